function build_mex(build, varargin)
% build_mex  Build slamicp_mex beside SLAMICP.m, in MATLAB or Octave; then addpath this folder.
%
%   build_mex                        needs a C++20 compiler, CMake and Eigen 3.4 (Debian: g++ cmake libeigen3-dev)
%   build_mex(folder)                keeps what is built between in that folder; default: build/mex of the project
%   build_mex(folder, '-DNAME=VALUE', ...)   hands options to CMake
%
% CMake builds the library (with the vector code for this processor, where Highway's headers are found: Debian libhwy-dev);
% mex builds the rest. Tried in Octave 7 on Linux. In MATLAB, and on Windows, it has not been tried.
%
% See also SLAMICP.

  here = fileparts(mfilename('fullpath'));
  project = fileparts(fileparts(here));
  if nargin < 1 || isempty(build)
    build = fullfile(project, 'build', 'mex');
  end
  options = sprintf(' "%s"', '-DCMAKE_BUILD_TYPE=Release', '-DBUILD_SHARED_LIBS=OFF', '-DSLAMICP_BUILD_IO=OFF', ...
                    '-DSLAMICP_BUILD_MATLAB=OFF', '-DSLAMICP_INSTALL=OFF', '-DCMAKE_UNITY_BUILD=ON', varargin{:});
  run(sprintf('cmake -S "%s" -B "%s"%s', project, build, options));
  run(sprintf('cmake --build "%s" --config Release --parallel --target slamicp_c_static', build));

  sources = dir(fullfile(here, 'src', '*.c'));
  sources = cellfun(@(name) fullfile(here, 'src', name), {sources.name}, 'UniformOutput', false);
  includes = {['-I' fullfile(project, 'bindings', 'c', 'include')]};
  libraries = {library(build, fullfile('bindings', 'c'), 'slamicp_c_static'), library(build, 'src', 'slamicp_core')};
  if exist('OCTAVE_VERSION', 'builtin')
    mex('-DSLAMICP_C_STATIC', includes{:}, sources{:}, libraries{:}, '-lstdc++', '-o', fullfile(here, 'slamicp_mex.mex'));
  elseif ispc
    mex('-R2017b', '-DSLAMICP_C_STATIC', includes{:}, sources{:}, libraries{:}, '-outdir', here, '-output', 'slamicp_mex');
  else
    mex('-R2017b', '-DSLAMICP_C_STATIC', 'CFLAGS=$CFLAGS -std=c11 -fexceptions', includes{:}, sources{:}, ...
        libraries{:}, '-lstdc++', '-outdir', here, '-output', 'slamicp_mex');
  end
  fprintf('built: %s\n', fullfile(here, ['slamicp_mex.' mexext()]));
end

function run(command)
  [status, told] = system(command);
  if status ~= 0
    error('slamicp:build', '%s\n%s', command, told);
  end
end

% Where CMake has put a library: compilers differ in folders and endings.
function path = library(build, folder, name)
  for ending = {['lib' name '.a'], [name '.lib'], fullfile('Release', [name '.lib'])}
    path = fullfile(build, folder, ending{1});
    if exist(path, 'file')
      return
    end
  end
  error('slamicp:build', 'there is no library %s in %s', name, fullfile(build, folder));
end
