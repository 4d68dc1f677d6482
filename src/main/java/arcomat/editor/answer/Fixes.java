package arcomat.editor.answer;

import arcomat.editor.desk.View;
import arcomat.editor.text.Positions;
import arcomat.source.Diagnostic;
import arcomat.source.Fix;
import arcomat.source.Span;

import org.eclipse.lsp4j.CodeAction;
import org.eclipse.lsp4j.CodeActionKind;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextEdit;
import org.eclipse.lsp4j.WorkspaceEdit;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The repairs that findings carry, each by itself, and those of a file all together. */
public final class Fixes {
    /** Of all repairs of a file; editors can be told to do that at each save. */
    public static final String ALL = CodeActionKind.SourceFixAll + ".arcomat";

    private Fixes() {}

    /**
     * What can be repaired in a range.
     *
     * @param kinds those that are asked for, with all below them; empty for all
     */
    public static List<CodeAction> at(View view, Range range, List<String> kinds) {
        List<CodeAction> actions = new ArrayList<>();
        if (isWanted(CodeActionKind.QuickFix, kinds)) {
            Span wanted = Positions.span(view.file(), range);
            view.findings().stream()
                    .filter(finding -> touches(finding.span(), wanted))
                    .forEach(
                            finding ->
                                    finding.fix()
                                            .ifPresent(
                                                    fix ->
                                                            actions.add(
                                                                    action(view, finding, fix))));
        }
        if (isWanted(ALL, kinds)) {
            all(view).ifPresent(actions::add);
        }
        return actions;
    }

    private static boolean isWanted(String kind, List<String> kinds) {
        return kinds.isEmpty()
                || kinds.stream()
                        .anyMatch(wanted -> kind.equals(wanted) || kind.startsWith(wanted + "."));
    }

    private static boolean touches(Span one, Span other) {
        return one.start() <= other.end() && other.start() <= one.end();
    }

    private static CodeAction action(View view, Diagnostic finding, Fix fix) {
        CodeAction action = new CodeAction(fix.title());
        action.setKind(CodeActionKind.QuickFix);
        action.setDiagnostics(List.of(Diagnostics.of(finding, view::address)));
        action.setEdit(edit(view, fix.edits()));
        action.setIsPreferred(true);
        return action;
    }

    /**
     * Of repairs that are in each other's way the first is done; the others show themselves again.
     */
    private static Optional<CodeAction> all(View view) {
        List<Fix.TextEdit> edits = new ArrayList<>();
        for (Diagnostic finding : view.findings()) {
            List<Fix.TextEdit> more = finding.fix().map(Fix::edits).orElse(List.of());
            if (more.stream().allMatch(edit -> isApart(edit, edits))) {
                edits.addAll(more);
            }
        }
        if (edits.isEmpty()) {
            return Optional.empty();
        }
        CodeAction action = new CodeAction("Repair what can be repaired in this file");
        action.setKind(ALL);
        action.setEdit(edit(view, edits));
        return Optional.of(action);
    }

    private static boolean isApart(Fix.TextEdit edit, List<Fix.TextEdit> others) {
        return others.stream()
                .noneMatch(
                        other ->
                                other.span().file().equals(edit.span().file())
                                        && touches(other.span(), edit.span()));
    }

    private static WorkspaceEdit edit(View view, List<Fix.TextEdit> edits) {
        Map<String, List<TextEdit>> changes = new LinkedHashMap<>();
        for (Fix.TextEdit edit : edits) {
            changes.computeIfAbsent(
                            view.address(edit.span().file().path()), any -> new ArrayList<>())
                    .add(new TextEdit(Positions.range(edit.span()), edit.text()));
        }
        return new WorkspaceEdit(changes);
    }
}
