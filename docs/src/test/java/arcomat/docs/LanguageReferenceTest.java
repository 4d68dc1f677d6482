package arcomat.docs;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Formatter;
import arcomat.syntax.Parser;
import arcomat.syntax.antlr.ArcomatLexer;
import arcomat.syntax.antlr.ArcomatParser;
import arcomat.syntax.antlr.ArcomatParser.ExpressionUnitContext;
import arcomat.translate.HouseLanguages;
import arcomat.tree.Unit;

import org.antlr.v4.runtime.CharStreams;
import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.tree.ParseTree;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The language reference tells the truth, and the whole of it. */
class LanguageReferenceTest {
    private static final Pattern DEFINITION =
            Pattern.compile(
                    "^(?:<<.*>> )?(?:component|automaton|classdiagram|testsuite) (\\w+)",
                    Pattern.MULTILINE);

    private static final Path PAGE = Path.of("docs/language.md");

    private static final List<String> GRAMMARS =
            List.of("Arc", "Automaton", "ClassDiagram", "Expression", "IoTable", "StreamTest");

    /** Types and literals; the page names them in its text. */
    private static final Set<String> WORDS_OF_JAVA =
            Set.of("boolean", "byte", "char", "double", "float", "int", "long", "new", "short");

    private static final Pattern COMMENT = Pattern.compile("(?s)//[^\n]*|/\\*.*?\\*/");
    private static final Pattern WORD = Pattern.compile("'([^']+)'");
    private static final Pattern DEFINED = Pattern.compile("(?m)^(\\w+) *:=");
    private static final Pattern USED = Pattern.compile("\\b[a-z]\\w*");

    private static List<Fence> examples;

    @BeforeAll
    static void readPage() throws IOException {
        examples = Fence.of(PAGE).stream().filter(Fence::isModel).toList();
    }

    /** Examples of the language and its productions, and nothing that this test would not see. */
    @Test
    void nothingElseIsShown() throws IOException {
        assertThat(Fence.of(PAGE))
                .allMatch(fence -> fence.isModel() || fence.language().equals("ebnf"));
    }

    /** The words of the grammars are those of the productions. */
    @Test
    void productionsHaveTheWordsOfTheGrammars() throws IOException {
        Set<String> written = new TreeSet<>();
        for (Fence fence : productionsOnThePage()) {
            WORD.matcher(fence.text()).results().forEach(word -> written.add(word.group(1)));
        }
        Set<String> wanted = new TreeSet<>();
        for (String grammar : GRAMMARS) {
            String rules = Files.readString(Path.of("grammar", grammar + ".g4"));
            WORD.matcher(COMMENT.matcher(rules).replaceAll(""))
                    .results()
                    .forEach(word -> wanted.add(word.group(1)));
        }
        wanted.removeAll(WORDS_OF_JAVA);
        wanted.addAll(Set.of("package", "import", "<<", ">>")); // in the grammar of all languages
        assertThat(written).isEqualTo(wanted);
    }

    @Test
    void productionsUseOnlyWhatIsDefined() throws IOException {
        Set<String> defined = new TreeSet<>(Set.of("literal", "text", "javaBlock"));
        Set<String> used = new TreeSet<>();
        for (Fence fence : productionsOnThePage()) {
            DEFINED.matcher(fence.text()).results().forEach(rule -> defined.add(rule.group(1)));
            USED.matcher(WORD.matcher(fence.text()).replaceAll(""))
                    .results()
                    .forEach(rule -> used.add(rule.group()));
        }
        assertThat(defined).isEqualTo(used);
    }

    private static List<Fence> productionsOnThePage() throws IOException {
        return Fence.of(PAGE).stream().filter(fence -> fence.language().equals("ebnf")).toList();
    }

    @Test
    void everyExampleParses() {
        for (Fence example : examples) {
            assertThat(Parser.parse(file(example)).findings()).as(example.toString()).isEmpty();
        }
    }

    @Test
    void everyExampleIsFormatted() {
        for (Fence example : examples) {
            assertThat(Formatter.format(file(example)).text()).contains(example.text());
        }
    }

    /**
     * Together the examples are one model without findings, but for those of older tools and
     * guests.
     */
    @Test
    void theExamplesAreOneCleanModel() {
        List<Unit> units =
                examples.stream()
                        .filter(example -> !Set.of("legacy", "guest").contains(example.title()))
                        .map(example -> Parser.parse(named(example)).unit().orElseThrow())
                        .toList();

        assertThat(
                        Checks.run(
                                Workspace.of(units, Set.of(), HouseLanguages.reader()),
                                Profile.REQUIREMENTS))
                .isEmpty();
    }

    /** An example for every production: none of the parser's rules and alternatives is missing. */
    @Test
    void everyProductionHasAnExample() {
        Set<Class<?>> shown = new HashSet<>();
        examples.forEach(example -> collect(tree(example), shown));

        List<String> missing =
                productions().stream()
                        .filter(production -> !shown.contains(production))
                        .map(Class::getSimpleName)
                        .sorted()
                        .toList();

        assertThat(missing).isEmpty();
    }

    /** A record per rule or labelled alternative; a rule with labels is only their common type. */
    private static List<Class<?>> productions() {
        List<Class<?>> productions = new ArrayList<>(List.of(ArcomatParser.class.getClasses()));
        Set<Class<?>> common = new HashSet<>();
        productions.forEach(production -> common.add(production.getSuperclass()));
        productions.removeAll(common);
        productions.remove(ExpressionUnitContext.class); // an entry for tools, not part of a file
        productions.removeIf(production -> !ParserRuleContext.class.isAssignableFrom(production));
        return productions;
    }

    private static void collect(ParseTree tree, Set<Class<?>> shown) {
        shown.add(tree.getClass());
        for (int i = 0; i < tree.getChildCount(); i++) {
            collect(tree.getChild(i), shown);
        }
    }

    private static ParserRuleContext tree(Fence example) {
        ArcomatLexer lexer = new ArcomatLexer(CharStreams.fromString(example.text()));
        ArcomatParser parser = new ArcomatParser(new CommonTokenStream(lexer));
        return switch (example.language()) {
            case "arc" -> parser.arcUnit();
            case "cd" -> parser.classDiagramUnit();
            case "mt" -> parser.testSuiteUnit();
            case "ioautomaton" -> parser.automatonUnit();
            default -> throw new AssertionError(example.language());
        };
    }

    /** Under the path that its package and name ask for. */
    private static SourceFile named(Fence example) {
        Matcher definition = DEFINITION.matcher(example.text());
        assertThat(definition.find()).isTrue();
        return new SourceFile(
                "tour/" + definition.group(1) + "." + example.language(), example.text());
    }

    private static SourceFile file(Fence example) {
        return new SourceFile("line" + example.line() + "." + example.language(), example.text());
    }
}
