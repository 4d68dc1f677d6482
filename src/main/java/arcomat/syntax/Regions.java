package arcomat.syntax;

import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatLexer;

import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.tree.ParseTree;
import org.antlr.v4.runtime.tree.TerminalNode;
import org.jspecify.annotations.Nullable;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/** What belongs together in a text, also where it does not parse: for who folds or selects it. */
public final class Regions {
    private Regions() {}

    /**
     * From each brace to the one that closes it, both included; in the order in which they open.
     */
    public static List<Span> braces(SourceFile file) {
        List<Span> pairs = new ArrayList<>();
        Deque<Token> open = new ArrayDeque<>();
        for (Token token : Reading.tokens(file).getTokens()) {
            if (token.getType() == ArcomatLexer.OPEN_BRACE) {
                open.push(token);
            } else if (token.getType() == ArcomatLexer.CLOSE_BRACE && !open.isEmpty()) {
                pairs.add(file.span(open.pop().getStartIndex(), token.getStopIndex() + 1));
            }
        }
        pairs.sort(Comparator.comparingInt(Span::start));
        return pairs;
    }

    /** Each comment; line comments with nothing but a line's end between them are one. */
    public static List<Span> comments(SourceFile file) {
        List<Span> comments = new ArrayList<>();
        for (Token token : Reading.tokens(file).getTokens()) {
            if (token.getChannel() == Token.HIDDEN_CHANNEL) {
                add(file.span(token.getStartIndex(), token.getStopIndex() + 1), comments);
            }
        }
        return comments;
    }

    private static void add(Span comment, List<Span> comments) {
        int last = comments.size() - 1;
        if (last >= 0 && goesOn(comments.get(last), comment)) {
            comments.set(last, comments.get(last).to(comment));
        } else {
            comments.add(comment);
        }
    }

    private static boolean goesOn(Span before, Span comment) {
        boolean areOfLines = before.text().startsWith("//") && comment.text().startsWith("//");
        return areOfLines
                && before.file().text().substring(before.end(), comment.start()).isBlank()
                && before.endPosition().line() + 1 == comment.startPosition().line();
    }

    /** All that is around an offset and has a meaning of its own, from a word to the whole text. */
    public static List<Span> around(SourceFile file, int offset) {
        List<Span> found =
                Reading.use(
                        file, Reading.Leaves.KEPT, reading -> rules(file, reading.root(), offset));
        braces(file).stream().filter(pair -> isIn(pair, offset)).forEach(found::add);
        found.add(file.span(0, file.text().length()));
        return found.stream()
                .distinct()
                .sorted(Comparator.comparingInt(span -> span.end() - span.start()))
                .toList();
    }

    private static boolean isIn(Span span, int offset) {
        return span.start() <= offset && offset <= span.end();
    }

    private static List<Span> rules(SourceFile file, @Nullable ParserRuleContext root, int offset) {
        List<Span> found = new ArrayList<>();
        Optional<ParseTree> current = Optional.ofNullable(root);
        while (current.isPresent()) {
            ParseTree node = current.get();
            span(file, node).filter(span -> isIn(span, offset)).ifPresent(found::add);
            current = childAt(file, node, offset);
        }
        return found;
    }

    /** Of two that meet at the offset, the one behind it. */
    private static Optional<ParseTree> childAt(SourceFile file, ParseTree node, int offset) {
        Optional<ParseTree> found = Optional.empty();
        for (int i = 0; i < node.getChildCount(); i++) {
            ParseTree child = node.getChild(i);
            if (span(file, child).filter(span -> isIn(span, offset)).isPresent()) {
                found = Optional.of(child);
            }
        }
        return found;
    }

    /** Empty for what has no text, as a rule that matched nothing. */
    private static Optional<Span> span(SourceFile file, ParseTree node) {
        if (node instanceof TerminalNode leaf) {
            return span(file, leaf.getSymbol(), leaf.getSymbol());
        }
        ParserRuleContext rule = (ParserRuleContext) node;
        return rule.getStart() == null || rule.getStop() == null
                ? Optional.empty()
                : span(file, rule.getStart(), rule.getStop());
    }

    private static Optional<Span> span(SourceFile file, Token first, Token last) {
        int end = Math.min(last.getStopIndex() + 1, file.text().length());
        return 0 <= first.getStartIndex() && first.getStartIndex() < end
                ? Optional.of(file.span(first.getStartIndex(), end))
                : Optional.empty();
    }
}
