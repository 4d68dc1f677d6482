package arcomat.syntax;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.time.Duration;
import java.util.concurrent.atomic.AtomicReference;

/** Deep and long texts: read, or rejected with a finding, on the stack of an ordinary thread. */
class NestingTest {
    private static final int FINE = 300;
    private static final int TOO_DEEP = 10_000;

    @ParameterizedTest
    @CsvSource({
        "(, a, )",
        "'- ', a, ''",
        "!, a, ''",
        "'a + ', a, ''",
        "'a implies ', a, ''",
        "'a ? b : ', a, ''",
        "'if a then b else ', a, ''",
        "'(A) ', a, ''",
        "'(int) ', a, ''",
        "f(, a, )",
        "'', a, .b",
        "'', a, [0]",
        "'', a, ' isin {b}'",
    })
    void expressions(String before, String middle, String after) {
        SourceFile fine = Texts.expression(nested(before, middle, after, FINE));
        assertThat(parse(fine).findings()).isEmpty();
        assertThat(Formatter.format(fine).text()).isPresent();
        assertTooDeep(Texts.expression(nested(before, middle, after, TOO_DEEP)));
    }

    @ParameterizedTest
    @CsvSource({
        "component A {, }",
        "compute {, }",
        "'automaton { a / {x = ', '}; }'",
        "port in A<, '> a;'",
    })
    void bodies(String before, String after) {
        assertTooDeep(Texts.component(before.repeat(TOO_DEEP) + after.repeat(TOO_DEEP)));
    }

    @Test
    void whatIsLongButFlatIsFine() {
        String transition = "a -> b [x > 3 && y < 5] {x = alt {a, b}} / {y = -3 * 4};\n";
        String states = "state a" + ", b".repeat(TOO_DEEP) + ";\n";
        String automaton = "<<x>> automaton { " + states + transition.repeat(TOO_DEEP) + "}\n";
        String components = "<<x, y = \"z\">> component B { timing sync; }\n".repeat(TOO_DEEP);
        assertThat(parse(Texts.component(automaton + components)).findings()).isEmpty();
    }

    /** However many operands a row has, none lies deeper for it. */
    @ParameterizedTest
    @ValueSource(strings = {" && ", " || ", " && !a || ", " && a == b && ", " || -a < +b && "})
    void rowsAreNoNesting(String operator) {
        SourceFile row = Texts.expression("a" + (operator + "a").repeat(TOO_DEEP));
        assertThat(parse(row).findings()).isEmpty();
        assertThat(Formatter.format(row).text()).isPresent();
        SourceFile broken = Texts.expression("a" + (operator + "a").repeat(TOO_DEEP) + " a");
        assertThat(parse(broken).findings()).extracting(Diagnostic::code).contains("ARC0001");
    }

    @ParameterizedTest
    @CsvSource({"(a && , a, )", "a && (b || , a, )", "'a || b implies ', a, ''"})
    void nestingInRowsIsNesting(String before, String middle, String after) {
        assertTooDeep(Texts.expression(nested(before, middle, after, TOO_DEEP)));
    }

    /** As in a browser, where no other stack can be had. */
    @Test
    void lessIsReadOnTheCallersStack() {
        Parsed fine = Parser.parseHere(Texts.expression(nested("(", "a", ")", 250)));
        assertThat(fine.findings()).isEmpty();
        Parsed deep = Parser.parseHere(Texts.expression(nested("(", "a", ")", 350)));
        assertThat(deep.unit()).isEmpty();
        assertThat(deep.findings())
                .first()
                .extracting(Diagnostic::message)
                .asString()
                .contains("more than 300 levels");
    }

    private static String nested(String before, String middle, String after, int levels) {
        return before.repeat(levels) + middle + after.repeat(levels);
    }

    private static void assertTooDeep(SourceFile file) {
        Parsed parsed = parse(file);
        assertThat(parsed.unit()).isEmpty();
        assertThat(parsed.findings())
                .extracting(Diagnostic::code)
                .containsExactly("ARC0006", "ARC0008");
    }

    /** On a stack of half a megabyte. */
    private static Parsed parse(SourceFile file) {
        AtomicReference<Parsed> result = new AtomicReference<>();
        Thread thread = new Thread(null, () -> result.set(Parser.parse(file)), "small", 512 << 10);
        thread.start();
        try {
            thread.join(Duration.ofSeconds(60).toMillis());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        assertThat(result.get()).as("parsed without overflow and in time").isNotNull();
        return result.get();
    }
}
