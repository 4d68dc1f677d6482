package arcomat.syntax;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.syntax.Reading.Leaves;
import arcomat.syntax.antlr.ArcomatParser;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.atn.PredictionMode;

import java.util.ArrayList;
import java.util.List;

/** What is read with a table says what ANTLR's exact mode says, which asks at each place anew. */
class ReadingTest {
    private static final List<String> WORDS =
            List.of(
                    "a",
                    "b",
                    "a[1]",
                    "a.b",
                    "1",
                    "true",
                    "--",
                    "++",
                    "==",
                    "==",
                    "=",
                    "!=",
                    "&&",
                    "||",
                    "?",
                    ":",
                    "|",
                    ",",
                    ";",
                    "(",
                    ")",
                    "[",
                    "]",
                    "{",
                    "}",
                    "alt {",
                    "!",
                    "-",
                    "+",
                    "<",
                    "call",
                    "implies",
                    "if",
                    "then",
                    "else",
                    "isin {",
                    "instanceof",
                    "f(a)",
                    "new");

    @Property(seed = "1", tries = 2000)
    void itemsAreReadAsByTheExactMode(@ForAll("items") List<String> words) {
        check("automaton A { state s; s {" + String.join(" ", words) + "} / {a = 1}; s -> s; }");
    }

    /** Mostly equations, and what they may be mistaken for. */
    @Provide
    Arbitrary<List<String>> items() {
        Arbitrary<List<String>> anything = Arbitraries.of(WORDS).list().ofMaxSize(7);
        Arbitrary<String> compared = Arbitraries.of("a ==", "a[1] ==", "a =", "a.b ==", "f(a) ==");
        return Arbitraries.oneOf(
                anything,
                compared.flatMap(
                        first ->
                                anything.map(
                                        rest -> {
                                            List<String> words = new ArrayList<>(List.of(first));
                                            words.addAll(rest);
                                            return words;
                                        })));
    }

    private static void check(String text) {
        SourceFile file = new SourceFile("A.ioautomaton", text);
        List<Diagnostic> exact = new ArrayList<>();
        ParserRuleContext tree = exact(file, exact);
        Reading.use(
                file,
                Leaves.KEPT,
                reading -> {
                    if (reading.root() != null) {
                        assertThat(reading.findings()).as(text).isEqualTo(exact);
                        assertThat(shape(reading.root())).as(text).isEqualTo(shape(tree));
                    }
                    return true;
                });
    }

    private static ParserRuleContext exact(SourceFile file, List<Diagnostic> findings) {
        ArcomatParser parser = new ArcomatParser(Reading.tokens(file));
        parser.removeErrorListeners();
        parser.setErrorHandler(new Recovery(file, findings));
        parser.getInterpreter().setPredictionMode(PredictionMode.LL_EXACT_AMBIG_DETECTION);
        return parser.automatonUnit();
    }

    private static String shape(ParserRuleContext tree) {
        return tree.toStringTree(List.of(ArcomatParser.ruleNames));
    }
}
