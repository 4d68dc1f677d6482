package arcomat.syntax;

import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatLexer;
import arcomat.syntax.antlr.ArcomatParser;
import arcomat.syntax.runtime.RuleNode;

import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.tree.ErrorNode;
import org.antlr.v4.runtime.tree.ParseTree;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Takes what has an error out of a parse tree, so that the rest can be built. */
final class Gaps {
    private static final Set<Integer> OF_TABLES =
            Set.of(
                    ArcomatParser.RULE_tableInputs,
                    ArcomatParser.RULE_tableOutputs,
                    ArcomatParser.RULE_row);

    private final SourceFile file;
    private final List<Span> gaps = new ArrayList<>();

    private Gaps(SourceFile file) {
        this.file = file;
    }

    /**
     * The gaps that are left in a tree that {@link Recovery} made. Empty where too much is missing:
     * the definition itself, or the package and the imports, without which no name means anything.
     */
    static Optional<List<Span>> takeFrom(ParserRuleContext root, SourceFile file) {
        Gaps gaps = new Gaps(file);
        ParseTree header = root.getChild(0);
        ParseTree definition = root.getChild(1);
        if (gaps.isGap(header) || !(definition instanceof ParserRuleContext body)) {
            return Optional.empty();
        }
        gaps.take((ParserRuleContext) header);
        if (gaps.isGap(body) || !gaps.gaps.isEmpty()) {
            return Optional.empty();
        }
        gaps.take(body);
        return Optional.of(List.copyOf(gaps.gaps));
    }

    private void take(ParserRuleContext context) {
        ((RuleNode) context).removeChildrenIf(this::isGap);
        for (int i = 0; i < context.getChildCount(); i++) {
            takeInside(context.getChild(i));
        }
    }

    /** Elements lie in elements, never in expressions, whose trees may be deep. */
    private void takeInside(ParseTree child) {
        if (child instanceof ParserRuleContext context
                && context.getRuleIndex() != ArcomatParser.RULE_expression) {
            take(context);
        }
    }

    private boolean isGap(ParseTree child) {
        if (child instanceof ErrorNode error) {
            add(error.getSymbol(), error.getSymbol());
            return true;
        }
        if (child instanceof ParserRuleContext context && isBroken(context)) {
            add(context.start, context.stop == null ? context.start : context.stop);
            return true;
        }
        return false;
    }

    /**
     * Whoever reads the text of a table again sees where its lines end, and no repairs: there it
     * does matter that a semicolon is missing.
     */
    private static boolean isBroken(ParserRuleContext context) {
        return context.exception != null
                || OF_TABLES.contains(context.getRuleIndex())
                        && context.stop.getType() != ArcomatLexer.SEMICOLON;
    }

    private void add(Token first, Token last) {
        int start = Math.max(0, first.getStartIndex());
        int end = Math.max(first.getStopIndex(), last.getStopIndex()) + 1;
        add(file.span(start, Math.min(Math.max(start, end), file.text().length())));
    }

    /** What was skipped in several steps is one gap. */
    private void add(Span gap) {
        int latest = gaps.size() - 1;
        if (latest >= 0 && isBehind(gaps.get(latest), gap)) {
            gaps.set(latest, gaps.get(latest).to(gap));
        } else {
            gaps.add(gap);
        }
    }

    private boolean isBehind(Span first, Span second) {
        return first.end() <= second.start()
                && file.span(first.end(), second.start()).text().isBlank();
    }
}
