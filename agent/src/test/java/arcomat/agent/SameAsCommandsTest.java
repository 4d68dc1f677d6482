package arcomat.agent;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.cli.Embedded;

import com.fasterxml.jackson.databind.JsonNode;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.List;

/** What a tool answers is, letter for letter, what the command prints for programs. */
class SameAsCommandsTest {
    private static final Path HERE = Path.of("").toAbsolutePath();
    private static final String MODELS = "models/coffee";
    private static final int SECONDS = 60;
    private static final int LONGEST = 100_000_000;

    @Tag("some-slow")
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '"',
            textBlock =
                    """
                    check | {} | check --format json models/coffee
                    check | {'profile':'executable','paths':['models/coffee/coffee/fig6/AvoidCrash.arc']} | \
                    check --profile executable --format json models/coffee/coffee/fig6/AvoidCrash.arc
                    explain | {} | explain
                    test | {} | test --format json models/coffee
                    refines | {'left':'coffee.fig5.AvoidCrash','right':'coffee.fig3.AvoidCrash'} | \
                    refines --format json coffee.fig5.AvoidCrash coffee.fig3.AvoidCrash models/coffee
                    refines | {'left':'coffee.fig5.AvoidCrash','right':'coffee.fig3.AvoidCrash','completion':'ignore,ignore'} | \
                    refines --completion ignore,ignore --format json coffee.fig5.AvoidCrash coffee.fig3.AvoidCrash models/coffee
                    simulate | {'component':'coffee.fetcher.Fetcher','seed':7,'slices':50,'whyNot':true} | \
                    simulate --main coffee.fetcher.Fetcher --seed 7 --slices 50 --why-not --trace json models/coffee
                    simulate | {'input':'models/coffee/coffee/fig6/AvoidCrashTest.mt#waits','choose':'random'} | \
                    simulate --input models/coffee/coffee/fig6/AvoidCrashTest.mt#waits --choose random --trace json
                    world | {'world':'models/coffee/world/meeting.world','seed':3} | \
                    world --seed 3 --format json models/coffee/world/meeting.world
                    """)
    void sameText(String tool, String arguments, String command) throws Exception {
        assertThat(answer(tool, arguments)).isEqualTo(printed(command.split(" ")));
    }

    private static String answer(String tool, String arguments) throws IOException {
        try (AgentClient client = new AgentClient(HERE, List.of(MODELS), SECONDS, LONGEST)) {
            JsonNode result = client.call(tool, arguments.replace('\'', '"'));
            assertThat(result.get("isError").asBoolean()).as(result.toString()).isFalse();
            assertThat(result.get("content")).hasSize(1);
            return result.get("content").get(0).get("text").asText();
        }
    }

    private static String printed(String... command) throws InterruptedException {
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        Embedded.run(HERE, new PrintWriter(out), new PrintWriter(err), command);
        assertThat(err.toString()).isEmpty();
        return out.toString();
    }
}
