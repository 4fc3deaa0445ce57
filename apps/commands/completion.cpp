// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Scripts that complete the command's words in a shell, made from its own declarations.

#include <iostream>
#include <sstream>

#include "command.h"

namespace gestalt::app::completion_command {

namespace {

std::vector<const CLI::App*> subcommands(const CLI::App& command) { return command.get_subcommands({}); }

/// What may follow the words of path: subcommands and options.
std::string words_after(const CLI::App& command) {
  std::string words;
  for (const CLI::App* sub : subcommands(command)) words += sub->get_name() + ' ';
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) words += "--" + name + ' ';
  if (!words.empty()) words.pop_back();
  return words;
}

/// Calls f with the words that lead to a command, and the command; those above it first.
template <class F>
void for_each_command(const CLI::App& command, const std::string& path, const F& f) {
  f(path, command);
  for (const CLI::App* sub : subcommands(command)) for_each_command(*sub, path + ' ' + sub->get_name(), f);
}

/// Other words than commands and options are left to the shell: they are mostly files.
std::string bash_script(const CLI::App& root) {
  std::ostringstream paths, cases;
  for_each_command(root, root.get_name(), [&](const std::string& path, const CLI::App& command) {
    if (&command != &root) paths << (paths.str().empty() ? "" : " | ") << '"' << path << '"';
    cases << "    \"" << path << "\") words=\"" << words_after(command) << "\" ;;\n";
  });
  return "_gestalt() {\n"
         "  local i words path=gestalt\n"
         "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
         "    case \"$path ${COMP_WORDS[i]}\" in\n"
         "      " +
         paths.str() +
         ") path=\"$path ${COMP_WORDS[i]}\" ;;\n"
         "    esac\n"
         "  done\n"
         "  case $path in\n" +
         cases.str() +
         "  esac\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"${COMP_WORDS[COMP_CWORD]}\"))\n"
         "}\n"
         "complete -o default -F _gestalt gestalt\n";
}

/// In single quotes.
std::string quoted(std::string text) {
  for (std::size_t at = 0; (at = text.find_first_of("'\\", at)) != text.npos; at += 2) text.insert(at, 1, '\\');
  return "'" + text + "'";
}

std::string fish_script(const CLI::App& root) {
  std::ostringstream script;
  for_each_command(root, "", [&](const std::string& path, const CLI::App& command) {
    // All words of the path were seen, and no subcommand after it.
    std::string condition = "true";
    std::istringstream words(path);
    for (std::string word; words >> word;) condition += "; and __fish_seen_subcommand_from " + word;
    std::string others;
    for (const CLI::App* sub : subcommands(command)) others += ' ' + sub->get_name();
    if (!others.empty()) condition += "; and not __fish_seen_subcommand_from" + others;
    const std::string begin = "complete -c gestalt -n " + quoted(condition);
    for (const CLI::App* sub : subcommands(command))
      script << begin << " -f -a " << sub->get_name() << " -d " << quoted(sub->get_description()) << '\n';
    for (const CLI::Option* option : command.get_options())
      for (const std::string& name : option->get_lnames())
        script << begin << " -l " << name << (option->get_expected_max() > 0 ? " -r" : "") << " -d "
               << quoted(option->get_description()) << '\n';
  });
  return script.str();
}

int print_script(const CLI::App& root, const std::string& shell) {
  if (shell == "zsh") std::cout << "autoload -U +X bashcompinit && bashcompinit\n";
  std::cout << (shell == "fish" ? fish_script(root) : bash_script(root));
  return success;
}

void add_completion(CLI::App& app, Run& run) {
  const auto shell = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("completion", "Print a shell completion script");
  command->add_option("shell", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}))
      ->type_name("SHELL");
  command->footer(
      "Example, in ~/.bashrc or ~/.zshrc: source <(gestalt completion bash)\n"
      "         for fish: gestalt completion fish > ~/.config/fish/completions/gestalt.fish");
  command->callback([&app, shell, &run] { run = [&app, shell] { return print_script(app, *shell); }; });
}

const Subcommand subcommand(160, add_completion);

}  // namespace

}  // namespace gestalt::app::completion_command
