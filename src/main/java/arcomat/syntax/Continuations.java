package arcomat.syntax;

import arcomat.source.SourceFile;
import arcomat.syntax.antlr.ArcomatLexer;
import arcomat.syntax.antlr.ArcomatParser;

import org.antlr.v4.runtime.Token;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * What the grammar lets stand at a place.
 *
 * @param words keywords, in the order of the alphabet; that any of them may be a name does not
 *     count
 * @param names for each way in which a name may stand there, the rules of the grammar around it,
 *     innermost first; ways with fewer rules first
 */
public record Continuations(Set<String> words, Set<List<String>> names) {
    public Continuations {
        words = Collections.unmodifiableSet(new LinkedHashSet<>(words));
        names = Collections.unmodifiableSet(new LinkedHashSet<>(names));
    }

    /** Of the text before the place only what is around it counts, and the statement begun. */
    public static Continuations at(Caret caret, SourceFile file) {
        GrammarWalk walk = new GrammarWalk(ArcomatParser._ATN, Language.of(file).rule());
        for (Token token : tokens(caret, file)) {
            walk.take(token.getType());
        }
        Set<String> words = new TreeSet<>();
        List<List<String>> names = new ArrayList<>();
        walk.next(
                ArcomatParser.RULE_name,
                type -> addWord(type, words),
                rules -> names.add(named(rules)));
        names.sort(Comparator.comparing(List::size));
        return new Continuations(words, new LinkedHashSet<>(names));
    }

    private static List<Token> tokens(Caret caret, SourceFile file) {
        List<String> words = new ArrayList<>();
        for (List<String> body : caret.around()) {
            words.addAll(body);
            words.add("{");
        }
        words.addAll(caret.statement());
        SourceFile text = new SourceFile(file.path(), String.join(" ", words));
        return Reading.tokens(text).getTokens().stream()
                .filter(token -> token.getType() != Token.EOF)
                .toList();
    }

    private static void addWord(int type, Set<String> words) {
        String literal = type < 0 ? null : ArcomatLexer.VOCABULARY.getLiteralName(type);
        if (literal != null && Character.isLetter(literal.charAt(1))) {
            words.add(literal.substring(1, literal.length() - 1));
        }
    }

    private static List<String> named(List<Integer> rules) {
        return rules.stream().map(rule -> ArcomatParser.ruleNames[rule]).toList();
    }
}
