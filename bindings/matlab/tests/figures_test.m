% The examples draw, without a screen.
addpath(getenv('SLAMICP_EXAMPLES'));
warning('off', 'Octave:gnuplot-graphics');
graphics_toolkit('gnuplot');
for name = {'figure_6', 'figure_7', 'figure_8'}
  picture = fullfile(getenv('SLAMICP_OUT'), [name{1} '.png']);
  if exist(picture, 'file')
    delete(picture);
  end
  feval(name{1}, picture);
  made = dir(picture);
  assert(numel(made) == 1 && made.bytes > 5000);
end
disp('passed');
