package arcomat.pipeline.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.Trial;
import arcomat.pipeline.campaign.engine.TrialBytes;
import arcomat.world.Seeds;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Answers are tried as parts of letters, in the project that sends them. */
class TrialBytesTest {
    @Test
    void trialsKeepTheOrderOfTheirValues() throws IOException {
        Map<String, String> values = new LinkedHashMap<>();
        values.put("speed", "0.25");
        values.put("fetcher", "coffee.floor.Fetcher(3, \"ü\")");
        values.put("a", "");
        List<Trial> trials = List.of(new Trial(0, -1, Map.of()), new Trial(1L << 40, 5, values));
        List<Trial> read = TrialBytes.trials(TrialBytes.of(trials));
        assertThat(read).isEqualTo(trials);
        assertThat(read.get(1).values().keySet()).containsExactly("speed", "fetcher", "a");
    }

    @Test
    void trialsKeepTheirSeeds() throws IOException {
        Seeds seeds = Seeds.of(5).then(1250, 77).then(1251, -1);
        List<Trial> trials = List.of(new Trial(0, seeds, Map.of()));
        assertThat(TrialBytes.trials(TrialBytes.of(trials))).isEqualTo(trials);
    }
}
