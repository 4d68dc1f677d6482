package arcomat.syntax.layout;

import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;

import java.util.List;

/** Sets a token stream in canonical white space: the way into this package. */
public final class Layout {
    private final String source;
    private final List<Token> tokens;
    private final Structure structure;
    private final Lines lines;

    private Layout(String source, List<Token> tokens, ParserRuleContext root) {
        this.source = source;
        this.tokens = tokens;
        this.structure = Structure.of(root, tokens.size());
        this.lines = new Lines(structure);
    }

    /**
     * @param tokens every token of the text, comments and the end of the file included
     * @param root the parse tree, without errors
     */
    public static String format(String source, List<Token> tokens, ParserRuleContext root) {
        return new Layout(source, tokens, root).format();
    }

    private String format() {
        int last = 0;
        for (int i = 0; tokens.get(i).getType() != Token.EOF; i++) {
            Token token = tokens.get(i);
            String gap = source.substring(last, token.getStartIndex());
            int end = i;
            if (token.getChannel() != Token.DEFAULT_CHANNEL) {
                comment(token, i, gap);
            } else {
                end = Math.max(i, structure.verbatimEnd(token));
                token(token, tokens.get(end), gap);
            }
            i = end;
            last = tokens.get(end).getStopIndex() + 1;
        }
        return print(lines.all());
    }

    private void token(Token first, Token last, String gap) {
        if (structure.startsLine(first)) {
            lines.begin(structure.indent(first), isBlank(gap));
            lines.mark(first);
        }
        lines.add(first, text(first, last));
    }

    private String text(Token first, Token last) {
        return unix(source.substring(first.getStartIndex(), last.getStopIndex() + 1));
    }

    private void comment(Token comment, int index, String gap) {
        String text = unix(comment.getText()).stripTrailing();
        Token next = nextToken(index);
        boolean atEnd = next.getType() == Token.EOF;
        boolean ownLine = lines.isEmpty() || unix(gap).indexOf('\n') >= 0;
        if (ownLine && (atEnd || structure.startsLine(next))) {
            int level = atEnd ? 0 : structure.indent(next);
            // In front of a closing brace a comment still belongs to the body.
            int inner = !atEnd && structure.closesBody(next) ? level + 1 : level;
            lines.begin(inner, isBlank(gap));
            lines.addComment(indented(text, inner), false, false);
        } else {
            lines.addComment(text, ownLine, text.startsWith("//") || breakFollows(comment));
        }
    }

    private boolean breakFollows(Token comment) {
        int after = comment.getStopIndex() + 1;
        while (after < source.length() && " \t\f".indexOf(source.charAt(after)) >= 0) {
            after++;
        }
        return after >= source.length() || "\r\n".indexOf(source.charAt(after)) >= 0;
    }

    private Token nextToken(int index) {
        int next = index + 1;
        while (tokens.get(next).getChannel() != Token.DEFAULT_CHANNEL) {
            next++;
        }
        return tokens.get(next);
    }

    private static boolean isBlank(String gap) {
        return unix(gap).chars().filter(c -> c == '\n').count() >= 2;
    }

    private static String unix(String text) {
        return text.indexOf('\r') < 0 ? text : text.replace("\r\n", "\n").replace('\r', '\n');
    }

    /** Lines that begin with a star are set below the first one; others are left alone. */
    private static String indented(String text, int level) {
        if (!text.startsWith("/*") || text.indexOf('\n') < 0) {
            return text;
        }
        String[] lines = text.split("\n", -1);
        StringBuilder result = new StringBuilder(lines[0].stripTrailing());
        for (int i = 1; i < lines.length; i++) {
            if (!lines[i].strip().startsWith("*")) {
                return text;
            }
            result.append('\n').append("    ".repeat(level)).append(' ').append(lines[i].strip());
        }
        return result.toString();
    }

    // ---- printing -------------------------------------------------------------------------

    private static String print(List<Line> lines) {
        Columns.align(lines);
        StringBuilder text = new StringBuilder();
        Line before = null;
        for (Line line : lines) {
            if (before != null && isBlankBetween(before, line)) {
                text.append('\n');
            }
            text.append(Wrapping.wrap(line)).append('\n');
            before = line;
        }
        return text.toString();
    }

    private static boolean isBlankBetween(Line before, Line line) {
        if (before.opensBody || line.closesBody) {
            return false;
        }
        return line.blankBefore || before.isPackage || before.isImport && !line.isImport;
    }
}
