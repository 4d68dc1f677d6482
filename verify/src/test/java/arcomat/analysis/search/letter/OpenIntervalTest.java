package arcomat.analysis.search.letter;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Type;
import arcomat.model.Value;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/** Between numbers and characters that a guard compares with. */
class OpenIntervalTest {

    /** The first three values of each gap; empty where a gap has none. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
                    digit  | 3            | 2 1 0; 4 5 6
                    digit  | 0            | ; 1 2 3
                    digit  | 9            | 8 7 6;
                    digit  | 3 4          | 2 1 0; ; 5 6 7
                    digit  | 3 5          | 2 1 0; 4; 6 7 8
                    digit  | 2 8          | 1 0; 3 4 5; 9
                    digit  | -5 12        | ; 0 1 2;
                    digit  | -5           | ; 0 1 2
                    digit  | 12           | 9 8 7;
                    digit  | 10           | 9 8 7;
                    digit  | -1           | ; 0 1 2
                    long   | -9223372036854775808 | ; -9223372036854775807 -9223372036854775806 -9223372036854775805
                    long   | -9223372036854775807 | -9223372036854775808; -9223372036854775806 -9223372036854775805 -9223372036854775804
                    long   | 9223372036854775806  | 9223372036854775805 9223372036854775804 9223372036854775803; 9223372036854775807
                    long   | 9223372036854775807  | 9223372036854775806 9223372036854775805 9223372036854775804;
                    char   | c            | b a `; d e f
                    char   | a c          | ` _ ^; b; d e f
                    double | 1.0          | 0.0 -1.0 -2.0; 2.0 3.0 4.0
                    double | 1.0 2.0      | 0.0 -1.0 -2.0; 1.0000000000000002 1.0000000000000004 1.0000000000000007; 3.0 4.0 5.0
                    double | 1.0 3.0      | 0.0 -1.0 -2.0; 2.0 2.0000000000000004 2.000000000000001; 4.0 5.0 6.0
                    double | 1.0 1.0000000000000002 NaN | 0.0 -1.0 -2.0; ; 2.0 3.0 4.0
                    double | 1.0E300      | 9.999999999999999E299 9.999999999999998E299 9.999999999999996E299; 1.0000000000000002E300 1.0000000000000003E300 1.0000000000000005E300
                    double | Infinity     | -1.0 -2.0 -3.0;
                    double | -Infinity    | ; -1.0 -2.0 -3.0
                    float  | 1.0          | 0.0 -1.0 -2.0; 2.0 3.0 4.0
                    float  | 1.0 2.0      | 0.0 -1.0 -2.0; 1.0000001192092896 1.000000238418579 1.0000003576278687; 3.0 4.0 5.0
                    """)
    void theirFirstValues(String type, String values, String first) {
        List<Value> known =
                Arrays.stream(values.split(" ")).map(word -> value(type, word)).toList();
        String text =
                OpenInterval.between(type(type), known).stream()
                        .map(gap -> text(gap.first(3)))
                        .collect(Collectors.joining("; "))
                        .strip();
        assertThat(text).isEqualTo(first);
    }

    private static Type type(String name) {
        return switch (name) {
            case "digit" -> new Type.IntegerType(Type.Width.INT, 0, 9, true);
            case "long" -> Type.IntegerType.of(Type.Width.LONG);
            case "char" -> new Type.CharacterType();
            default -> new Type.RealType(name.equals("float"));
        };
    }

    private static Value value(String type, String word) {
        return switch (type) {
            case "char" -> new Value.CharacterValue(word.charAt(0));
            case "digit", "long" -> new Value.IntegerValue(Long.parseLong(word));
            default -> new Value.RealValue(Double.parseDouble(word));
        };
    }

    private static String text(List<Value> values) {
        return values.stream()
                .map(
                        value ->
                                value instanceof Value.CharacterValue c
                                        ? String.valueOf(c.value())
                                        : value.toString())
                .collect(Collectors.joining(" "));
    }
}
