package arcomat.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.stream.LongStream;
import java.util.stream.Stream;

class TrialsTest {
    private static Trials of(String... lines) {
        String text = "world a.world\n" + String.join("\n", lines);
        return Trials.of(
                CampaignParser.parse(new SourceFile("a.campaign", text)).campaign().orElseThrow());
    }

    private static Stream<Trial> all(Trials trials) {
        return LongStream.range(0, trials.count()).mapToObj(trials::trial);
    }

    @Test
    void withoutAParameterRunsDifferInTheirSeeds() {
        Trials trials = of("sample random 3", "seeds from 7");
        assertThat(all(trials).map(Trial::seed)).containsExactly(7L, 8L, 9L);
    }

    @Test
    void aGridHasEveryValueWithEveryOtherAndTheSameSeedsEverywhere() {
        Trials trials = of("vary n from 0 to 10", "vary who of A B", "sample grid 3 seeds 2");
        assertThat(all(trials).map(each -> each.seed() + " " + each.values()))
                .containsExactly(
                        "1 {n=0, who=A}",
                        "1 {n=0, who=B}",
                        "1 {n=5, who=A}",
                        "1 {n=5, who=B}",
                        "1 {n=10, who=A}",
                        "1 {n=10, who=B}",
                        "2 {n=0, who=A}",
                        "2 {n=0, who=B}",
                        "2 {n=5, who=A}",
                        "2 {n=5, who=B}",
                        "2 {n=10, who=A}",
                        "2 {n=10, who=B}");
    }

    /** As many as are not named: one. */
    @Test
    void aGridWithoutANumberOfSeedsHasOneSeedForAllPoints() {
        Trials trials = of("vary n from 0 to 10", "sample grid 5", "seeds from 7");
        assertThat(trials.count()).isEqualTo(5);
        assertThat(all(trials).map(Trial::seed)).containsOnly(7L);
        assertThat(all(trials).map(each -> each.values().get("n"))).doesNotHaveDuplicates();
    }

    @Test
    void wholeNumbersAreNotTakenTwice() {
        Trials trials = of("vary n from 2 to 4 whole", "sample grid 9");
        assertThat(all(trials).map(each -> each.values().get("n"))).containsExactly("2", "3", "4");
    }

    @Test
    void whatIsComparedDiffersInNothingElse() {
        Trials trials =
                of(
                        "vary light from 0 to 3",
                        "vary who of Old New",
                        "sample random 50",
                        "compare who by collision");
        List<Trial> runs = all(trials).toList();
        assertThat(runs).hasSize(100);
        for (int i = 0; i < runs.size(); i += 2) {
            assertThat(runs.get(i).values()).containsEntry("who", "Old");
            assertThat(runs.get(i + 1).values())
                    .containsEntry("who", "New")
                    .containsEntry("light", runs.get(i).values().get("light"));
            assertThat(runs.get(i).seed()).isEqualTo(runs.get(i + 1).seed());
        }
    }

    @Test
    void aLatinSampleMeetsEachPartOfARangeOnce() {
        Trials trials = of("vary light from 0 to 100", "sample latin 100");
        assertThat(
                        all(trials)
                                .map(each -> each.values().get("light"))
                                .map(light -> (int) Double.parseDouble(light)))
                .doesNotHaveDuplicates()
                .hasSize(100);
    }

    @Test
    void aNumberIsWrittenAsAWorldReadsIt() {
        Variation.Range range = new Variation.Range(-0.0000001, 1e9 / 3, false);
        assertThat(Stream.of(0.0, 1e-12, 0.1, 0.5, 0.999).map(range::at))
                .allMatch(text -> text.matches("-?\\d{1,9}(\\.\\d{1,9})?"));
    }

    @Test
    void aRangeOfWholeNumbersHasItsEnds() {
        Variation.Range range = new Variation.Range(1, 6, true);
        assertThat(Stream.of(0.0, 0.16, 0.17, 0.999, 1.0).map(range::at))
                .containsExactly("1", "1", "2", "6", "6");
    }
}
