package arcomat.syntax.build;

import arcomat.source.ComposedForm;
import arcomat.syntax.antlr.ArcomatLexer;
import arcomat.syntax.antlr.ArcomatParser;
import arcomat.tree.Unit.Spelling;
import arcomat.tree.Unit.Spelling.Kind;

import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.tree.ParseTree;
import org.jspecify.annotations.Nullable;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/** Finds the words of a text that may be read as others. */
final class Spellings {
    private Spellings() {}

    /** Those outside of blocks in another language. */
    static List<Spelling> in(List<Token> tokens, ParserRuleContext root, Phrases phrases) {
        List<Token> found = new ArrayList<>(0);
        for (Token token : tokens) {
            if (kind(token).isPresent()) {
                found.add(token);
            }
        }
        if (found.isEmpty()) {
            return List.of();
        }
        List<ParserRuleContext> foreign = foreignBlocks(root);
        return found.stream()
                .filter(token -> foreign.stream().noneMatch(block -> isIn(token, block)))
                .map(token -> new Spelling(phrases.span(token, token), kind(token).orElseThrow()))
                .toList();
    }

    private static Optional<Kind> kind(Token token) {
        return switch (token.getType()) {
            case ArcomatLexer.INT, ArcomatLexer.LONG -> ofNumber(token.getText());
            case ArcomatLexer.ID -> ofName(ComposedForm.of(token.getText()));
            default -> Optional.empty();
        };
    }

    private static Optional<Kind> ofNumber(String text) {
        if (text.charAt(0) != '0' || !text.matches("0[0-9_]*[0-9][lL]?")) {
            return Optional.empty();
        }
        return Optional.of(text.matches("[0-7_]+[lL]?") ? Kind.OCTAL : Kind.NOT_OCTAL);
    }

    /** Digits and signs are of every script. */
    private static Optional<Kind> ofName(String text) {
        Script first = null;
        for (int i = 0; i < text.length(); i++) {
            Script script = Script.of(text.charAt(i));
            if (script != null && first != null && script != first) {
                return Optional.of(Kind.MIXED_SCRIPTS);
            }
            first = script == null ? first : script;
        }
        return Optional.empty();
    }

    private static List<ParserRuleContext> foreignBlocks(ParserRuleContext root) {
        List<ParserRuleContext> blocks = new ArrayList<>();
        Deque<ParseTree> open = new ArrayDeque<>(List.of(root));
        while (!open.isEmpty()) {
            ParseTree tree = open.pop();
            if (tree instanceof ParserRuleContext context
                    && context.getRuleIndex() == ArcomatParser.RULE_javaBlock) {
                blocks.add(context);
            } else {
                for (int i = 0; i < tree.getChildCount(); i++) {
                    open.push(tree.getChild(i));
                }
            }
        }
        return blocks;
    }

    private static boolean isIn(Token token, ParserRuleContext block) {
        return block.start.getStartIndex() <= token.getStartIndex()
                && block.stop != null
                && token.getStopIndex() <= block.stop.getStopIndex();
    }

    /** The scripts of the letters that names have. */
    private enum Script {
        LATIN,
        GREEK,
        CYRILLIC;

        /** Null for a character that is no letter. */
        static @Nullable Script of(char c) {
            if (!Character.isLetter(c)) {
                return null;
            }
            if (c < '\u0370') {
                return LATIN;
            }
            return c < '\u0400' ? GREEK : CYRILLIC;
        }
    }
}
