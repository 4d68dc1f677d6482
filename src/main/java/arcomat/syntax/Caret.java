package arcomat.syntax;

import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatLexer;

import org.antlr.v4.runtime.Token;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * A place in a text where somebody is writing, told from what stands before it. Nothing needs to
 * parse for that: what is around the place is its braces with what stands in front of each, and
 * whatever lies beside them is left out.
 *
 * @param around the beginnings of what is around it, outermost first: {@code component Door}
 * @param statement the words of the statement that is being written, up to the place, but for the
 *     one that is being typed
 * @param written all of that statement that stands before the place
 * @param typed the word that is being typed, as far as it stands before the place; may be empty
 */
public record Caret(List<List<String>> around, List<String> statement, Span written, Span typed) {
    /** What begins something with a body of statements; other braces are parts of a statement. */
    private static final Set<String> BODIES =
            Set.of(
                    "component",
                    "automaton",
                    "implementation",
                    "table",
                    "classdiagram",
                    "class",
                    "enum",
                    "interface",
                    "testsuite",
                    "varif",
                    "test",
                    "input",
                    "expect",
                    "events");

    /** What may stand in front of the word that tells what begins. */
    private static final Set<String> MODIFIERS =
            Set.of(
                    "abstract",
                    "deploy",
                    "public",
                    "protected",
                    "private",
                    "final",
                    "static",
                    "derived",
                    "+",
                    "#",
                    "-",
                    "/");

    public Caret {
        around = around.stream().map(List::copyOf).toList();
        statement = List.copyOf(statement);
    }

    /**
     * The place at an offset; nothing inside of a comment or a string, where nothing of the
     * language is written.
     */
    public static Optional<Caret> at(SourceFile file, int offset) {
        List<Token> tokens = new ArrayList<>();
        SourceFile before = new SourceFile(file.path(), file.text().substring(0, offset));
        for (Token token : Reading.tokens(before).getTokens()) {
            boolean foreign = isForeign(token);
            if (foreign && token.getStopIndex() + 1 == offset) {
                return Optional.empty();
            }
            if (token.getType() != Token.EOF
                    && token.getChannel() == Token.DEFAULT_CHANNEL
                    && !foreign) {
                tokens.add(token);
            }
        }
        int typed = offset;
        if (!tokens.isEmpty()) {
            Token last = tokens.get(tokens.size() - 1);
            if (last.getStopIndex() + 1 == offset && isWord(last)) {
                typed = last.getStartIndex();
                tokens.remove(tokens.size() - 1);
            }
        }
        return Optional.of(new Reader(file).read(tokens, typed, offset));
    }

    /**
     * A line comment goes on to the end of its line, and what is not closed to that of the text.
     */
    private static boolean isForeign(Token token) {
        return switch (token.getType()) {
            case ArcomatLexer.LINE_COMMENT,
                    ArcomatLexer.UNCLOSED_COMMENT,
                    ArcomatLexer.UNCLOSED_STRING ->
                    true;
            default -> false;
        };
    }

    private static boolean isWord(Token token) {
        return Character.isJavaIdentifierStart(token.getText().charAt(0));
    }

    /** Goes through the words before the place. */
    private static final class Reader {
        private final SourceFile file;

        /** What is around the current word, innermost first. */
        private final Deque<List<Token>> bodies = new ArrayDeque<>();

        /** For each open brace whether it is that of a body. */
        private final Deque<Boolean> braces = new ArrayDeque<>();

        /** The brace that begins each of the bodies. */
        private final Deque<Token> openings = new ArrayDeque<>();

        private List<Token> statement = new ArrayList<>();

        Reader(SourceFile file) {
            this.file = file;
        }

        Caret read(List<Token> tokens, int typed, int offset) {
            tokens.forEach(this::take);
            if (isBehindVariation()) {
                statement = new ArrayList<>();
            }
            List<List<String>> around = new ArrayList<>();
            bodies.descendingIterator().forEachRemaining(each -> around.add(texts(each)));
            int start = statement.isEmpty() ? typed : statement.get(0).getStartIndex();
            return new Caret(
                    around, texts(statement), file.span(start, offset), file.span(typed, offset));
        }

        private static List<String> texts(List<Token> tokens) {
            return tokens.stream().map(Token::getText).toList();
        }

        private void take(Token token) {
            switch (token.getType()) {
                case ArcomatLexer.OPEN_BRACE -> open(token);
                case ArcomatLexer.CLOSE_BRACE -> close(token);
                case ArcomatLexer.SEMICOLON -> end(token);
                default -> {
                    if (isBehindVariation() && !token.getText().equals("else")) {
                        statement = new ArrayList<>();
                    }
                    statement.add(token);
                }
            }
        }

        /** A variation may go on, and then it is one statement with what it goes on with. */
        private boolean isBehindVariation() {
            return keyword(statement).equals("varif")
                    && statement.get(statement.size() - 1).getType() == ArcomatLexer.CLOSE_BRACE;
        }

        private void open(Token token) {
            boolean isBody = !isIn("automaton") && BODIES.contains(keyword(statement));
            braces.push(isBody);
            if (isBody) {
                bodies.push(statement);
                openings.push(token);
                statement = new ArrayList<>();
            } else {
                statement.add(token);
            }
        }

        /** In an automaton every brace belongs to a transition, whatever its state is called. */
        private boolean isIn(String keyword) {
            return !bodies.isEmpty() && keyword(bodies.peek()).equals(keyword);
        }

        /** The first word behind stereotypes and modifiers; empty where there is none. */
        private static String keyword(List<Token> statement) {
            int depth = 0;
            for (Token token : statement) {
                String text = token.getText();
                if (text.equals("<")) {
                    depth++;
                } else if (text.equals(">")) {
                    depth--;
                } else if (depth == 0 && !MODIFIERS.contains(text)) {
                    return text;
                }
            }
            return "";
        }

        private void close(Token token) {
            if (braces.isEmpty() || !braces.pop()) {
                statement.add(token);
            } else {
                List<Token> ended = bodies.pop();
                Token opened = openings.pop();
                statement = new ArrayList<>();
                if (keyword(ended).equals("varif")) {
                    statement.addAll(ended);
                    statement.add(opened);
                    statement.add(token);
                }
            }
        }

        /** Items of a block may be divided by semicolons, too. */
        private void end(Token token) {
            if (braces.isEmpty() || braces.peek()) {
                statement = new ArrayList<>();
            } else {
                statement.add(token);
            }
        }
    }
}
