package arcomat.editor.answer;

import arcomat.editor.desk.OtherTexts;
import arcomat.editor.desk.View;
import arcomat.editor.name.RenamePlan;
import arcomat.editor.name.RenameRefused;
import arcomat.editor.name.RenamedBeside;
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

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;

/** Renaming as editors do it. */
public final class Renames {
    private Renames() {}

    /** What would be renamed. */
    public static PrepareRenameResult prepare(View view, Position position) throws RenameRefused {
        Occurrence target = Renaming.target(view, view.offset(position));
        return new PrepareRenameResult(Positions.range(target.span()), target.span().text());
    }

    /**
     * What is to be done.
     *
     * @param warning of what is not done; for a person
     */
    public record Answer(WorkspaceEdit edit, Optional<String> warning) {}

    /**
     * @param movesFiles whether the editor can rename files as well
     * @param others what lies beside the models; asked once the models can be renamed
     * @param goOn asked now and then; it may throw what ends the work
     */
    public static Answer edit(
            View view,
            Position position,
            String name,
            boolean movesFiles,
            Supplier<OtherTexts> others,
            Runnable goOn)
            throws RenameRefused {
        Occurrence target = Renaming.target(view, view.offset(position));
        RenamePlan plan = Renaming.plan(view.models(), target.referent(), name, goOn);
        if (!plan.moves().isEmpty() && !movesFiles) {
            throw RenameRefused.becauseOfFiles(plan.moves());
        }
        RenamedBeside beside = RenamedBeside.of(plan, others.get());
        Map<String, List<TextEdit>> changes = changes(view, plan, beside);
        return new Answer(
                plan.moves().isEmpty()
                        ? new WorkspaceEdit(changes)
                        : new WorkspaceEdit(changesAndMoves(view, plan, changes)),
                beside.warning(view.models().root()));
    }

    private static Map<String, List<TextEdit>> changes(
            View view, RenamePlan plan, RenamedBeside beside) {
        Map<String, List<TextEdit>> changes = new LinkedHashMap<>();
        plan.edits().forEach((path, edits) -> changes.put(view.address(path), edits(edits)));
        beside.edits()
                .forEach(
                        (path, edits) ->
                                changes.put(Path.of(path).toUri().toString(), edits(edits)));
        return changes;
    }

    private static List<TextEdit> edits(List<Fix.TextEdit> edits) {
        return edits.stream()
                .map(each -> new TextEdit(Positions.range(each.span()), each.text()))
                .toList();
    }

    /** First the texts, under their old names. */
    private static List<Either<TextDocumentEdit, ResourceOperation>> changesAndMoves(
            View view, RenamePlan plan, Map<String, List<TextEdit>> changes) {
        List<Either<TextDocumentEdit, ResourceOperation>> all = new ArrayList<>();
        changes.forEach((address, edits) -> all.add(Either.forLeft(changed(address, edits))));
        plan.moves()
                .forEach(
                        (from, to) ->
                                all.add(
                                        Either.forRight(
                                                new RenameFile(
                                                        view.address(from), view.address(to)))));
        return all;
    }

    private static TextDocumentEdit changed(String address, List<TextEdit> edits) {
        return new TextDocumentEdit(
                new VersionedTextDocumentIdentifier(address, null),
                edits.stream().map(Either::<TextEdit, SnippetTextEdit>forLeft).toList());
    }
}
