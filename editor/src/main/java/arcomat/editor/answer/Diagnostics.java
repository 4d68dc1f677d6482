package arcomat.editor.answer;

import arcomat.editor.text.Positions;
import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.Diagnostic;

import org.eclipse.lsp4j.DiagnosticRelatedInformation;
import org.eclipse.lsp4j.DiagnosticSeverity;
import org.eclipse.lsp4j.DiagnosticTag;
import org.eclipse.lsp4j.Location;
import org.eclipse.lsp4j.Range;

import java.util.List;
import java.util.Set;
import java.util.function.Function;

/** Findings as editors show them. */
public final class Diagnostics {
    /** Of something that could as well not be there, which editors show paler. */
    private static final Set<String> NEEDLESS = Set.of("ARC0123");

    private Diagnostics() {}

    /**
     * @param addresses of the files of these models
     */
    public static List<org.eclipse.lsp4j.Diagnostic> of(
            OpenModels models, String path, Function<String, String> addresses) {
        return of(models.findings(path), addresses);
    }

    /**
     * @param addresses of the files that findings are about
     */
    public static List<org.eclipse.lsp4j.Diagnostic> of(
            List<Diagnostic> findings, Function<String, String> addresses) {
        return findings.stream().map(each -> of(each, addresses)).toList();
    }

    static org.eclipse.lsp4j.Diagnostic of(Diagnostic finding, Function<String, String> addresses) {
        Range range = Positions.range(finding.span());
        var shown = new org.eclipse.lsp4j.Diagnostic(range, finding.message());
        shown.setCode(finding.code());
        shown.setSource("arcomat");
        shown.setSeverity(
                finding.isError() ? DiagnosticSeverity.Error : DiagnosticSeverity.Warning);
        shown.setRelatedInformation(
                finding.related().stream()
                        .map(
                                each ->
                                        new DiagnosticRelatedInformation(
                                                new Location(
                                                        addresses.apply(each.span().file().path()),
                                                        Positions.range(each.span())),
                                                each.note()))
                        .toList());
        if (NEEDLESS.contains(finding.code())) {
            shown.setTags(List.of(DiagnosticTag.Unnecessary));
        }
        return shown;
    }
}
