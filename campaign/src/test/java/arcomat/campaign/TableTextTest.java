package arcomat.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.Row.Ending;
import arcomat.campaign.coverage.ReachedItems;
import arcomat.source.SourceFile;

import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

class TableTextTest {
    private static final Campaign CAMPAIGN =
            CampaignParser.parse(
                            new SourceFile(
                                    "a.campaign", "world a.world\nvary a of x y\nsample random 9"))
                    .campaign()
                    .orElseThrow();
    private static final TableText TEXT = new TableText(CAMPAIGN);

    private static Trial trial(String value) {
        return new Trial(4, 5, Map.of("a", value));
    }

    @Property
    void whatIsWrittenIsRead(@ForAll double number, @ForAll String value, @ForAll String why) {
        List<Double> answers = new ArrayList<>();
        CAMPAIGN.columns().forEach(column -> answers.add(number));
        Row made = Row.made(trial(oneLine(value)), answers, new ReachedItems("x0c"));
        assertThat(TEXT.line(made)).endsWith(",x0c");
        assertThat(TEXT.row(TEXT.line(made))).isEqualTo(made);
        Row none = Row.withoutAnswers(trial("x"), Ending.IMPOSSIBLE, why);
        assertThat(TEXT.row(TEXT.line(none))).isEqualTo(none);
        assertThat(TEXT.line(none)).doesNotContain("\n");
    }

    /** As a word of a campaign is. */
    private static String oneLine(String text) {
        return text.replaceAll("\\s", "_");
    }

    @Example
    void wholeNumbersHaveNoFractionAndWhatIsNoneIsEmpty() {
        List<Double> answers = new ArrayList<>();
        CAMPAIGN.columns().forEach(column -> answers.add(answers.isEmpty() ? 1 : Double.NaN));
        assertThat(TEXT.line(Row.made(trial("x"), answers))).startsWith("4,5,x,made,1,,,");
    }
}
