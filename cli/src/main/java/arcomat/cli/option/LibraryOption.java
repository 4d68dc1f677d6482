package arcomat.cli.option;

import picocli.CommandLine.Option;

import java.util.ArrayList;
import java.util.List;

/** Of commands about models: those of others that they may refer to. */
public final class LibraryOption {
    @Option(
            names = "--library",
            paramLabel = "DIR",
            description =
                    "A model root of somebody else that the models may refer to: of it only errors"
                            + " are told, and nothing is asked or made. May be repeated.")
    private List<String> folders = new ArrayList<>();

    /** As the user wrote them. */
    public List<String> folders() {
        return folders;
    }
}
