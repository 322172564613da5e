# fish completion for rgimp: bash's, whose file is asked what may stand where.

set --global __rgimp_script (status dirname)/../../bash-completion/completions/rgimp

function __rgimp_offers
    set --local word (commandline --current-token)
    set --local offers (bash $__rgimp_script (commandline --tokenize --cut-at-cursor --current-process) "$word")
    switch "$offers[1]"
        case @DIR
            __fish_complete_directories "$word"
        case '@FILE.*'
            set --local ending (string replace @FILE '' -- $offers[1] | string escape --style=regex)
            __fish_complete_path "$word" | string match --regex ".*(?:$ending|/)(?:\t.*)?\$"
        case @FILE
            __fish_complete_path "$word"
        case '*'
            printf '%s\n' $offers
    end
end

complete --command rgimp --no-files --arguments '(__rgimp_offers)'
