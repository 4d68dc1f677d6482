package arcomat.syntax.layout;

import arcomat.syntax.antlr.ArcomatParser;

import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/** Collects tokens and comments into lines, one element each. */
final class Lines {
    private final Structure structure;
    private final Spacing spacing;
    private final List<Line> lines = new ArrayList<>();
    private Line current = new Line(0, false);
    private @Nullable Token previous;
    private int depth;
    private boolean mustBreak;

    Lines(Structure structure) {
        this.structure = structure;
        this.spacing = new Spacing(structure);
    }

    boolean isEmpty() {
        return lines.isEmpty();
    }

    List<Line> all() {
        return lines;
    }

    void begin(int level, boolean blankBefore) {
        current = new Line(level, blankBefore);
        lines.add(current);
        previous = null;
        depth = 0;
        mustBreak = false;
    }

    /** Notes what the first token says of its line. */
    void mark(Token first) {
        current.closesBody = structure.closesBody(first);
        int rule = structure.rule(first);
        current.isPackage = rule == ArcomatParser.RULE_packageDeclaration;
        current.isImport = rule == ArcomatParser.RULE_importDeclaration;
        if (rule == ArcomatParser.RULE_row) {
            current.table = structure.parent(first).getParent();
        }
    }

    void add(Token token, String text) {
        boolean space =
                previous == null ? !current.pieces.isEmpty() : spacing.isNeeded(previous, token);
        leave(token);
        boolean bar =
                structure.rule(token) == ArcomatParser.RULE_row && token.getText().equals("|");
        current.pieces.add(new Line.Piece(text, space, breakLevel(token), mustBreak, bar));
        enter(token);
        mustBreak = false;
        previous = token;
        current.opensBody = structure.opensBody(token);
    }

    /**
     * @param before whether it stands on a line of its own inside an element
     * @param after whether a line must begin behind it
     */
    void addComment(String text, boolean before, boolean after) {
        current.pieces.add(new Line.Piece(text, true, -1, before || mustBreak, false));
        mustBreak = after;
        previous = null;
    }

    private void enter(Token token) {
        if ("([{".contains(token.getText()) && !structure.opensBody(token)) {
            depth++;
        }
    }

    private void leave(Token token) {
        if (")]}".contains(token.getText()) && depth > 0) {
            depth--;
        }
    }

    /** Two levels for each bracket: at separators first, then at operators and inner lists. */
    private int breakLevel(Token token) {
        if (previous == null) {
            return -1;
        }
        ParserRuleContext parent = structure.parent(token);
        ParserRuleContext left = structure.parent(previous);
        String before = previous.getText();
        if (token.getText().equals("/")
                && (parent instanceof ArcomatParser.TransitionContext
                        || parent instanceof ArcomatParser.InitialContext)) {
            return 0;
        }
        if (before.equals(",") || before.equals(";")) {
            return 2 * depth + innerLevels(left.getRuleIndex());
        }
        if (parent instanceof ArcomatParser.BinaryExpressionContext) {
            return 2 * depth + 1;
        }
        if (token == parent.start && opensPartOfTransition(parent)) {
            return 1;
        }
        boolean word =
                token.getText().equals("extends")
                        || token.getText().equals("refines")
                        || token.getText().equals("implements");
        return word && depth == 0 ? 0 : -1;
    }

    private static boolean opensPartOfTransition(ParserRuleContext context) {
        return context.getParent() instanceof ArcomatParser.TransitionContext transition
                && (context == transition.guard() || context == transition.input);
    }

    /** Lists that are better kept together than those around them. */
    private static int innerLevels(int rule) {
        return switch (rule) {
            case ArcomatParser.RULE_port -> 1;
            case ArcomatParser.RULE_typeParameters, ArcomatParser.RULE_typeArguments -> 2;
            default -> 0;
        };
    }
}
