package arcomat.editor.answer;

import arcomat.editor.desk.View;
import arcomat.editor.name.RenamePlan;
import arcomat.editor.name.RenameRefused;
import arcomat.editor.name.Renaming;
import arcomat.editor.text.Positions;
import arcomat.source.Fix;
import arcomat.symbols.occurrences.Occurrence;

import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.PrepareRenameResult;
import org.eclipse.lsp4j.RenameFile;
import org.eclipse.lsp4j.ResourceOperation;
import org.eclipse.lsp4j.SnippetTextEdit;
import org.eclipse.lsp4j.TextDocumentEdit;
import org.eclipse.lsp4j.TextEdit;
import org.eclipse.lsp4j.VersionedTextDocumentIdentifier;
import org.eclipse.lsp4j.WorkspaceEdit;
import org.eclipse.lsp4j.jsonrpc.messages.Either;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Renaming as editors do it. */
public final class Renames {
    private Renames() {}

    /** What would be renamed. */
    public static PrepareRenameResult prepare(View view, Position position) throws RenameRefused {
        Occurrence target = Renaming.target(view, view.offset(position));
        return new PrepareRenameResult(Positions.range(target.span()), target.span().text());
    }

    /**
     * @param movesFiles whether the editor can rename files as well
     * @param goOn asked now and then; it may throw what ends the work
     */
    public static WorkspaceEdit edit(
            View view, Position position, String name, boolean movesFiles, Runnable goOn)
            throws RenameRefused {
        Occurrence target = Renaming.target(view, view.offset(position));
        RenamePlan plan = Renaming.plan(view.models(), target.referent(), name, goOn);
        if (plan.moves().isEmpty()) {
            return new WorkspaceEdit(changes(view, plan));
        }
        if (!movesFiles) {
            throw RenameRefused.becauseOfFiles(plan.moves());
        }
        return new WorkspaceEdit(changesAndMoves(view, plan));
    }

    private static Map<String, List<TextEdit>> changes(View view, RenamePlan plan) {
        Map<String, List<TextEdit>> changes = new LinkedHashMap<>();
        plan.edits().forEach((path, edits) -> changes.put(view.address(path), edits(edits)));
        return changes;
    }

    private static List<TextEdit> edits(List<Fix.TextEdit> edits) {
        return edits.stream()
                .map(each -> new TextEdit(Positions.range(each.span()), each.text()))
                .toList();
    }

    /** First the texts, under their old names. */
    private static List<Either<TextDocumentEdit, ResourceOperation>> changesAndMoves(
            View view, RenamePlan plan) {
        List<Either<TextDocumentEdit, ResourceOperation>> all = new ArrayList<>();
        changes(view, plan)
                .forEach(
                        (address, edits) ->
                                all.add(
                                        Either.forLeft(
                                                new TextDocumentEdit(
                                                        new VersionedTextDocumentIdentifier(
                                                                address, null),
                                                        edits.stream()
                                                                .map(
                                                                        Either
                                                                                ::<TextEdit,
                                                                                        SnippetTextEdit>forLeft)
                                                                .toList()))));
        plan.moves()
                .forEach(
                        (from, to) ->
                                all.add(
                                        Either.forRight(
                                                new RenameFile(
                                                        view.address(from), view.address(to)))));
        return all;
    }
}
