package arcomat.editor.server;

import org.eclipse.lsp4j.ClientCapabilities;
import org.eclipse.lsp4j.ResourceOperationKind;

/**
 * What an editor can do beyond what all of them can.
 *
 * @param watches whether it tells of files that others change, once it is asked to
 * @param movesFiles whether it renames files
 * @param refreshesLenses whether it asks for lenses again when it is told to
 * @param showsDocuments whether it opens a file when it is asked to
 */
record Abilities(
        boolean watches, boolean movesFiles, boolean refreshesLenses, boolean showsDocuments) {
    static final Abilities NONE = new Abilities(false, false, false, false);

    static Abilities of(ClientCapabilities said) {
        return said == null
                ? NONE
                : new Abilities(
                        watches(said), movesFiles(said), refreshesLenses(said), shows(said));
    }

    private static boolean watches(ClientCapabilities said) {
        var workspace = said.getWorkspace();
        var watching = workspace == null ? null : workspace.getDidChangeWatchedFiles();
        return watching != null && Boolean.TRUE.equals(watching.getDynamicRegistration());
    }

    private static boolean movesFiles(ClientCapabilities said) {
        var workspace = said.getWorkspace();
        var edits = workspace == null ? null : workspace.getWorkspaceEdit();
        return edits != null
                && Boolean.TRUE.equals(edits.getDocumentChanges())
                && edits.getResourceOperations() != null
                && edits.getResourceOperations().contains(ResourceOperationKind.Rename);
    }

    private static boolean refreshesLenses(ClientCapabilities said) {
        var workspace = said.getWorkspace();
        var lenses = workspace == null ? null : workspace.getCodeLens();
        return lenses != null && Boolean.TRUE.equals(lenses.getRefreshSupport());
    }

    private static boolean shows(ClientCapabilities said) {
        var window = said.getWindow();
        var showing = window == null ? null : window.getShowDocument();
        return showing != null && showing.isSupport();
    }
}
