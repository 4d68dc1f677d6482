package arcomat.cli.command.serve;

import arcomat.cli.command.Command;
import arcomat.cli.option.LibraryOption;
import arcomat.cli.terminal.Version;
import arcomat.editor.LanguageService;
import arcomat.pipeline.Session;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;

import java.nio.file.Path;
import java.util.List;

/** {@code arcomat language-server}: serves an editor. */
@CommandLine.Command(
        name = "language-server",
        description =
                "Serves an editor, which starts it and talks to it on standard input and output.",
        footer = {
            "Models of others that the models may refer to are named by --library, or by a setting"
                    + " of the",
            "editor: arcomat.libraries, a list of folders.",
            "",
            "It speaks the Language Server Protocol. Editors are told to start it for files that"
                    + " end in",
            ".arc, .cd, .ioautomaton, .maa and .mt; docs/editors.md has the lines for several of"
                    + " them.",
            "",
            "Exit status: 0 the editor took its leave; 1 it broke off; 2 wrong use."
        })
public final class LanguageServerCommand extends Command {
    @Mixin private LibraryOption library = new LibraryOption();

    @Override
    protected List<String> libraries() {
        return library.folders();
    }

    @Override
    protected int run(Session session) {
        List<Path> libraries =
                session.libraries().stream()
                        .map(each -> session.names().resolve(each).normalize())
                        .toList();
        try {
            return LanguageService.serve(
                    System.in, System.out, Version.number(), session.guests(), libraries);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return 1;
        }
    }
}
