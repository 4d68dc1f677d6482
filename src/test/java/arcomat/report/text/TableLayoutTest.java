package arcomat.report.text;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

/** Tables that do not fit. */
class TableLayoutTest {
    private static TextTable table() {
        TextTable table = new TextTable(List.of("slice", "input", "state", "because"));
        table.add(
                List.of(
                        "0",
                        "ultrasonic.distance = 2",
                        "standing -> following",
                        "{cmd == fwd} / {leftSpeed = cruise, rightSpeed = cruise}"));
        table.add(List.of("1", "x = 1", "following", "no transition fits: the input is ignored"));
        table.add(List.of("", "y = 2", "", ""));
        return table;
    }

    private static String letters(String text) {
        return text.replaceAll("[\\s-]", "");
    }

    @Test
    void narrowColumnsAreBrokenAtWords() {
        assertThat(table().render(Style.PLAIN.within(60)))
                .isEqualTo(
                        """
                        slice  input         state      because
                        -----  ------------  ---------  ----------------------------
                            0  ultrasonic.   standing   {cmd == fwd} / {leftSpeed =
                               distance = 2  ->         cruise, rightSpeed = cruise}
                                             following
                            1  x = 1         following  no transition fits: the
                                                        input is ignored
                               y = 2
                        """);
    }

    @ParameterizedTest
    @ValueSource(ints = {30, 40, 50, 60, 70, 80, 90, 100, 110})
    void everyLineFitsAndNothingIsLost(int width) {
        String fitted = table().render(Style.PLAIN.within(width));
        assertThat(fitted.lines()).allMatch(line -> line.length() <= width);
        String wide = table().render(Style.PLAIN);
        assertThat(letters(fitted).chars().sorted().toArray())
                .isEqualTo(letters(wide).chars().sorted().toArray());
    }

    @Test
    void whatFitsIsAsWideAsItIs() {
        assertThat(table().render(Style.PLAIN.within(111))).isEqualTo(table().render(Style.PLAIN));
    }

    @Test
    void rowsThatFollowKeepTheColumns() {
        TextTable table = table();
        String begun = table.begin(Style.PLAIN.within(80), 8);
        List<String> row = List.of("10000000", "a.very.long.name = " + "9".repeat(40), "s", "t");
        assertThat(begun + table.more(row)).contains("10000000  a.very.");
        assertThat((begun + table.more(row)).lines()).allMatch(line -> line.length() <= 83);
        assertThat(table.more(row).replaceAll("\\s", "")).contains("9".repeat(10));
    }
}
