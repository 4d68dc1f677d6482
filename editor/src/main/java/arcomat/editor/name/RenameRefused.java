package arcomat.editor.name;

import java.util.Map;
import java.util.stream.Collectors;

/** Why something cannot be renamed, or not so, for whoever wanted to; a whole sentence. */
public final class RenameRefused extends Exception {
    private static final long serialVersionUID = 1;

    private final String reason;

    RenameRefused(String reason) {
        super(reason);
        this.reason = reason;
    }

    public String reason() {
        return reason;
    }

    /** For an editor that only changes texts. */
    public static RenameRefused becauseOfFiles(Map<String, String> moves) {
        return new RenameRefused(
                "this editor renames no files, and these would have to be: "
                        + moves.entrySet().stream()
                                .map(each -> each.getKey() + " to " + each.getValue())
                                .collect(Collectors.joining(", ")));
    }
}
