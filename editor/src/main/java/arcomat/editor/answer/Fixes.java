package arcomat.editor.answer;

import arcomat.editor.desk.View;
import arcomat.editor.text.Positions;
import arcomat.source.Diagnostic;
import arcomat.source.Fix;
import arcomat.source.Span;

import org.eclipse.lsp4j.CodeAction;
import org.eclipse.lsp4j.CodeActionContext;
import org.eclipse.lsp4j.CodeActionKind;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextEdit;
import org.eclipse.lsp4j.WorkspaceEdit;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/** The repairs that findings carry, each by itself, and those of a file all together. */
public final class Fixes {
    /** Of all repairs of a file; editors can be told to do that at each save. */
    public static final String ALL = CodeActionKind.SourceFixAll + ".arcomat";

    private Fixes() {}

    /**
     * What can be repaired in a range. Where the editor tells which findings it is about, it is
     * about no other: Kate asks for the whole file, and does all that it is offered. So the repairs
     * of a file are not put beside that of a finding unless they are asked for.
     *
     * @param context the findings that the editor shows there, and the kinds of repairs that it
     *     asks for, with all below them; without kinds all
     */
    public static List<CodeAction> at(View view, Range range, CodeActionContext context) {
        List<String> kinds = Objects.requireNonNullElse(context.getOnly(), List.of());
        List<CodeAction> actions = new ArrayList<>();
        if (isWanted(CodeActionKind.QuickFix, kinds)) {
            actions.addAll(about(context.getDiagnostics(), inRange(view, range)));
        }
        if (isWanted(ALL, kinds) && (actions.isEmpty() || !kinds.isEmpty())) {
            all(view).ifPresent(actions::add);
        }
        return actions;
    }

    private static List<CodeAction> inRange(View view, Range range) {
        Span wanted = Positions.span(view.file(), range);
        return view.findings().stream()
                .filter(finding -> touches(finding.span(), wanted))
                .flatMap(finding -> finding.fix().stream().map(fix -> action(view, finding, fix)))
                .toList();
    }

    /** Those of findings that are shown; of all where others are shown by now. */
    private static List<CodeAction> about(
            List<org.eclipse.lsp4j.Diagnostic> shown, List<CodeAction> actions) {
        List<CodeAction> about = actions.stream().filter(action -> isAbout(shown, action)).toList();
        return about.isEmpty() ? actions : about;
    }

    private static boolean isAbout(List<org.eclipse.lsp4j.Diagnostic> shown, CodeAction action) {
        return action.getDiagnostics().stream()
                .anyMatch(
                        finding ->
                                shown.stream()
                                        .anyMatch(
                                                each ->
                                                        each.getRange().equals(finding.getRange())
                                                                && Objects.equals(
                                                                        each.getCode(),
                                                                        finding.getCode())));
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
