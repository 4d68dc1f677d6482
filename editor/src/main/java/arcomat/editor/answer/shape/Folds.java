package arcomat.editor.answer.shape;

import arcomat.editor.desk.View;
import arcomat.source.Span;
import arcomat.syntax.Regions;
import arcomat.tree.Unit;

import org.eclipse.lsp4j.FoldingRange;
import org.eclipse.lsp4j.FoldingRangeKind;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What an editor can fold: whatever takes several lines. */
public final class Folds {
    private static final Optional<String> COMMENT = Optional.of(FoldingRangeKind.Comment);
    private static final Optional<String> IMPORTS = Optional.of(FoldingRangeKind.Imports);

    private Folds() {}

    public static List<FoldingRange> of(View view) {
        List<FoldingRange> folds = new ArrayList<>();
        view.parsed()
                .readable()
                .flatMap(Folds::imports)
                .ifPresent(span -> add(span, line(span.end(), span), IMPORTS, folds));
        Regions.comments(view.file())
                .forEach(span -> add(span, line(span.end(), span), COMMENT, folds));
        // The line of the brace that closes stays to be seen.
        Regions.braces(view.file())
                .forEach(span -> add(span, line(span.end(), span) - 1, Optional.empty(), folds));
        return folds;
    }

    private static Optional<Span> imports(Unit unit) {
        List<Unit.Import> imports = unit.imports();
        return imports.isEmpty()
                ? Optional.empty()
                : Optional.of(imports.get(0).span().to(imports.get(imports.size() - 1).span()));
    }

    private static void add(Span span, int last, Optional<String> kind, List<FoldingRange> folds) {
        int first = line(span.start(), span);
        if (first < last) {
            FoldingRange fold = new FoldingRange(first, last);
            kind.ifPresent(fold::setKind);
            folds.add(fold);
        }
    }

    private static int line(int offset, Span span) {
        return span.file().position(offset).line() - 1;
    }
}
