package arcomat.cli.command.shell;

import arcomat.cli.command.Command;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Session;

import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code arcomat completion}: what a shell needs to complete commands and options. */
@CommandLine.Command(
        name = "completion",
        description = "Prints what a shell needs to complete commands, options and their values.",
        footer = {
            "  source <(arcomat completion bash)    in ~/.bashrc",
            "  source <(arcomat completion zsh)    in ~/.zshrc",
            "  arcomat completion fish > ~/.config/fish/completions/arcomat.fish",
            "",
            "The distribution has the same in its folder share.",
            "",
            "Exit status: 0 printed; 2 wrong use."
        })
public final class CompletionCommand extends Command {
    enum Shell {
        bash,
        zsh,
        fish
    }

    @Spec private CommandSpec spec;

    @Parameters(paramLabel = "SHELL", description = "One of ${COMPLETION-CANDIDATES}.")
    private Shell shell;

    @Override
    protected int run(Session session) {
        CommandLine tool = spec.root().commandLine();
        print(
                switch (shell) {
                    // One text for both: it asks which of them reads it.
                    case bash, zsh -> AutoComplete.bash(tool.getCommandName(), tool);
                    case fish -> FishCompletion.of(tool);
                });
        return ExitStatus.FINE;
    }
}
