#include "describe.hpp"

#include "gapflow/scene/key_reference.hpp"

#include <CLI/CLI.hpp>

#include <vector>

namespace gapflow {

namespace {

/// Subcommands that help lists.
std::vector<const CLI::App*> commands_of(const CLI::App& app)
{
    return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

/// Options that help lists, positional ones first.
std::vector<const CLI::Option*> options_of(const CLI::App& app)
{
    std::vector<const CLI::Option*> all;
    for (const bool positional : {true, false})
        for (const CLI::Option* option : app.get_options())
            if (option->get_positional() == positional)
                all.push_back(option);
    return all;
}

bool takes_value(const CLI::Option& option)
{
    return option.get_items_expected_max() > 0;
}

/// -o, --output: as typed, without the value.
std::vector<std::string> words_of(const CLI::Option& option)
{
    std::vector<std::string> words;
    for (const std::string& name : option.get_snames())
        words.push_back("-" + name);
    for (const std::string& name : option.get_lnames())
        words.push_back("--" + name);
    return words;
}

std::string joined_words(const CLI::Option& option, const std::string& separator = ", ")
{
    std::string text;
    for (const std::string& word : words_of(option))
        text += (text.empty() ? "" : separator) + word;
    return text;
}

/// What a user may type: "[--set key=value]... SCENE.toml".
std::string synopsis_of(const CLI::App& command)
{
    std::string text;
    for (const CLI::Option* option : options_of(command)) {
        const std::string value = option->get_type_name();
        if (option->get_positional()) {
            text += " " + value + (option->get_expected_max() > 1 ? "..." : "");
            continue;
        }
        const std::string word = words_of(*option).back() + (takes_value(*option) ? " " + value : "");
        if (word == "--help")
            continue;
        text += option->get_required() ? " " + word : " [" + word + "]";
    }
    return text;
}

std::string escaped(const std::string& text, const std::string& what, char with)
{
    std::string out;
    for (const char c : text) {
        if (what.find(c) != std::string::npos)
            out += with;
        out += c;
    }
    return out;
}

std::string man_text(const std::string& text)
{
    return escaped(text, "-\\", '\\');
}

std::string man_options(const CLI::App& command)
{
    std::string out;
    for (const CLI::Option* option : options_of(command)) {
        out += ".TP\n";
        if (option->get_positional())
            out += ".I " + man_text(option->get_type_name()) + "\n";
        else
            out += ".B " + man_text(joined_words(*option)) +
                   (takes_value(*option) ? " " + man_text(option->get_type_name()) : "") + "\n";
        out += man_text(option->get_description()) + ".\n";
    }
    return out;
}

std::string man_page(const CLI::App& app, const std::string& version)
{
    std::string out = ".TH GAPFLOW 1 \"\" \"gapflow " + version + "\" \"Gapflow\"\n.SH NAME\ngapflow \\- " +
                      man_text(app.get_description()) + "\n.SH SYNOPSIS\n";
    for (const CLI::App* command : commands_of(app))
        out += ".B gapflow " + man_text(command->get_name()) + "\n" + man_text(synopsis_of(*command)).substr(1) + "\n.br\n";
    out += ".SH COMMANDS\n";
    for (const CLI::App* command : commands_of(app)) {
        out += ".SS gapflow " + man_text(command->get_name()) + "\n" + man_text(command->get_description()) + ".\n" +
               man_options(*command);
        if (!command->get_footer().empty())
            out += ".PP\n" + man_text(command->get_footer()) + "\n";
    }
    return out + ".SH EXIT STATUS\n" + man_text(app.get_footer()) + "\n.SH SEE ALSO\n.BR gapflow\\-scene (5)\n";
}

std::string markdown(const CLI::App& app)
{
    std::string out = "# The command\n\n" + app.get_description() + ".\n\n" + app.get_footer() +
                      "\n\nThis page is what `gapflow generate markdown` writes; `gapflow COMMAND --help` says the same.\n";
    for (const CLI::App* command : commands_of(app)) {
        out += "\n## gapflow " + command->get_name() + "\n\n    gapflow " + command->get_name() + synopsis_of(*command) +
               "\n\n" + command->get_description() + ".\n\n| | |\n|---|---|\n";
        for (const CLI::Option* option : options_of(*command)) {
            const std::string value = option->get_type_name();
            const std::string words = joined_words(*option, "`, `");
            out += "| `" + (option->get_positional() ? value : words + (takes_value(*option) ? " " + value : "")) + "` | " +
                   escaped(option->get_description(), "|<[]", '\\') + " |\n";
        }
        if (!command->get_footer().empty())
            out += "\n" + command->get_footer() + "\n";
    }
    return out;
}

/// Kind of a value, for completion: a scene, a folder, another file, a key, or unknown.
std::string value_kind(const CLI::Option& option)
{
    const std::string type = option.get_type_name();
    if (type == "SCENE.toml")
        return "scene";
    if (type == "DIR")
        return "folder";
    if (type.starts_with("FILE"))
        return "file";
    return type.starts_with("key=") ? "key" : "";
}

std::string bash(const CLI::App& app)
{
    std::string names, cases;
    for (const CLI::App* command : commands_of(app)) {
        names += (names.empty() ? "" : " ") + command->get_name();
        std::string words, values, first;
        for (const CLI::Option* option : options_of(*command)) {
            const std::string kind = value_kind(*option);
            if (option->get_positional()) {
                first = kind;
                continue;
            }
            words += (words.empty() ? "" : " ") + joined_words(*option, " ");
            if (takes_value(*option))
                values += "            " + joined_words(*option, "|") + ") kind=" + (kind.empty() ? "none" : kind) + " ;;\n";
        }
        cases +=
            "    " + command->get_name() + ")\n        words=\"" + words + "\" kind=" + (first.empty() ? "none" : first) + "\n";
        if (!values.empty())
            cases += "        case $before in\n" + values + "        esac\n";
        cases += "        ;;\n";
    }
    return R"bash(# bash completion of gapflow
_gapflow()
{
    local current=$2 before=$3 words="" kind=none
    COMPREPLY=()
    [ "$before" = "=" ] && return
    if [ "$COMP_CWORD" -eq 1 ]; then
        COMPREPLY=($(compgen -W ")bash" +
           names + R"bash( --help --version" -- "$current"))
        return
    fi
    case ${COMP_WORDS[1]} in
)bash" + cases +
           R"bash(    esac
    case $current in
    -*) COMPREPLY=($(compgen -W "$words" -- "$current")) ;;
    *)
        case $kind in
        scene) COMPREPLY=($(compgen -f -X '!*.toml' -- "$current") $(compgen -d -S / -- "$current")); compopt -o nospace ;;
        folder) COMPREPLY=($(compgen -d -- "$current")) ;;
        file) COMPREPLY=($(compgen -f -- "$current")) ;;
        key) COMPREPLY=($(compgen -S = -W "$(gapflow keys --names 2>/dev/null)" -- "$current")); compopt -o nospace ;;
        esac
        ;;
    esac
}
complete -F _gapflow gapflow
)bash";
}

std::string zsh(const CLI::App& app)
{
    std::string names, cases;
    const auto quoted = [](const std::string& text) { return escaped(text, "\\[]:'", '\\'); };
    for (const CLI::App* command : commands_of(app)) {
        const auto plain = [](std::string text) { // inside '...'
            std::string out;
            for (const char c : text)
                out += c == '\'' ? std::string("’") : std::string(1, c);
            return out;
        };
        names += "        '" + command->get_name() + ":" + plain(command->get_description()) + "'\n";
        cases += "    " + command->get_name() + ")\n        _arguments";
        for (const CLI::Option* option : options_of(*command)) {
            const std::string kind = value_kind(*option);
            const std::string action = kind == "scene"    ? "_files -g \"*.toml\""
                                       : kind == "folder" ? "_files -/"
                                       : kind == "file"   ? "_files"
                                       : kind == "key"    ? "_gapflow_keys"
                                                          : " ";
            if (option->get_positional()) {
                cases += " \\\n            '1:" + quoted(option->get_type_name()) + ":" + action + "'";
                continue;
            }
            for (const std::string& word : words_of(*option))
                cases += " \\\n            '*" + word + "[" + quoted(plain(option->get_description())) + "]" +
                         (takes_value(*option) ? ":" + quoted(option->get_type_name()) + ":" + action : "") + "'";
        }
        cases += "\n        ;;\n";
    }
    return "#compdef gapflow\n_gapflow_keys()\n{\n    compadd -S = -- ${(f)\"$(gapflow keys --names "
           "2>/dev/null)\"}\n}\n\n_gapflow()\n{\n"
           "    local -a commands=(\n" +
           names +
           "    )\n    if (( CURRENT == 2 )); then\n        _describe command commands\n        return\n    fi\n"
           "    local name=$words[2]\n    shift words\n    (( CURRENT-- ))\n    case $name in\n" +
           cases + "    esac\n}\n_gapflow \"$@\"\n";
}

std::string fish(const CLI::App& app)
{
    const auto quoted = [](const std::string& text) { return "'" + escaped(text, "'\\", '\\') + "'"; };
    std::string out = "# fish completion of gapflow\ncomplete -c gapflow -f\n";
    for (const CLI::App* command : commands_of(app)) {
        const std::string within = "complete -c gapflow -n '__fish_seen_subcommand_from " + command->get_name() + "'";
        out += "complete -c gapflow -n __fish_use_subcommand -a " + command->get_name() + " -d " +
               quoted(command->get_description()) + "\n";
        for (const CLI::Option* option : options_of(*command)) {
            const std::string kind = value_kind(*option);
            const std::string values = kind == "scene"    ? " -a '(__fish_complete_suffix .toml)'"
                                       : kind == "folder" ? " -a '(__fish_complete_directories)'"
                                       : kind == "key"    ? " -a '(gapflow keys --names 2>/dev/null)='"
                                       : kind == "file"   ? " -F"
                                                          : "";
            out += within;
            for (const std::string& name : option->get_snames())
                out += " -s " + name;
            for (const std::string& name : option->get_lnames())
                out += " -l " + name;
            out += takes_value(*option) && !option->get_positional() ? " -r" + values : values;
            out += option->get_positional() ? "\n" : " -d " + quoted(option->get_description()) + "\n";
        }
    }
    return out;
}

} // namespace

std::string describe(const CLI::App& app, const std::string& kind, const std::string& version)
{
    if (kind == "man")
        return man_page(app, version);
    if (kind == "markdown")
        return markdown(app);
    if (kind == "bash")
        return bash(app);
    if (kind == "zsh")
        return zsh(app);
    if (kind == "fish")
        return fish(app);
    return kind == "scene-man" ? key_manual(version) : key_page();
}

} // namespace gapflow
