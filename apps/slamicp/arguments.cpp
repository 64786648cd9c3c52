// SPDX-License-Identifier: Apache-2.0
#include "arguments.hpp"

#ifdef _WIN32
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
// After windows.h.
#include <shellapi.h>
#endif

namespace slamicp::command {
namespace {

#ifdef _WIN32

std::string utf8(const wchar_t* text) {
  const int size = WideCharToMultiByte(CP_UTF8, 0, text, -1, nullptr, 0, nullptr, nullptr);
  if (size <= 1) return {};
  std::string bytes(static_cast<std::size_t>(size), '\0');
  WideCharToMultiByte(CP_UTF8, 0, text, -1, bytes.data(), size, nullptr, nullptr);
  bytes.pop_back();  // the end mark
  return bytes;
}

std::vector<std::string> texts_of(int argc, char** argv) {
  SetConsoleOutputCP(CP_UTF8);
  int count = 0;
  wchar_t** const words = CommandLineToArgvW(GetCommandLineW(), &count);
  if (words == nullptr) return {argv, argv + argc};
  std::vector<std::string> texts;
  for (int k = 0; k < count; ++k) texts.push_back(utf8(words[k]));
  LocalFree(words);
  return texts;
}

#else

std::vector<std::string> texts_of(int argc, char** argv) { return {argv, argv + argc}; }

#endif

}  // namespace

Arguments::Arguments(int argc, char** argv) : texts_(texts_of(argc, argv)) {
  for (std::string& text : texts_) words_.push_back(text.data());
  words_.push_back(nullptr);
}

}  // namespace slamicp::command
