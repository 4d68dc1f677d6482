package arcomat.syntax;

import static org.assertj.core.api.Assertions.assertThat;

import org.antlr.v4.Tool;
import org.antlr.v4.runtime.BailErrorStrategy;
import org.antlr.v4.runtime.CharStreams;
import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.ParserInterpreter;
import org.antlr.v4.tool.Grammar;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The grammars that others import are languages of their own. */
class GrammarTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = '~',
            value = {
                "Lexical~header~package p; import a.b.*;",
                "Expression~expressionUnit~if a > 1 then b.c else f(x)[2] * -3",
                "Automaton~automatonUnit~automaton A { state a; initial a; a {x = 1} / {y}; }",
                "IoTable~ioTable~table { in a; out b; | * | => | 1 |; }",
                "ClassDiagram~classDiagramUnit~classdiagram D { enum E { a, b; } }",
                "StreamTest~testSuiteUnit~testsuite S for C { test t { input { a: <1>; } } }",
            })
    void standsAlone(String name, String rule, String text) {
        Tool tool = new Tool(new String[] {"-lib", "grammar"});
        Grammar grammar = tool.loadGrammar("grammar/" + name + ".g4");
        assertThat(tool.getNumErrors()).isZero();
        ParserInterpreter parser =
                grammar.createParserInterpreter(
                        new CommonTokenStream(
                                grammar.createLexerInterpreter(CharStreams.fromString(text))));
        parser.setErrorHandler(new BailErrorStrategy());
        assertThat(parser.parse(grammar.getRule(rule).index).getText()).isNotEmpty();
        assertThat(parser.getNumberOfSyntaxErrors()).isZero();
    }
}
