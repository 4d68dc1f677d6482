package arcomat.report.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The page of a campaign loads nothing, and takes words of campaigns for words. */
class CampaignPageTest {
    private static final String NASTY = "</script><b>&amp;";
    private static final Pattern DATA =
            Pattern.compile(
                    "<script type=\"application/json\" id=\"data\">(.*?)</script>", Pattern.DOTALL);

    private static JsonNode data(String page) throws IOException {
        Matcher data = DATA.matcher(page);
        assertThat(data.find()).isTrue();
        return new ObjectMapper().readTree(data.group(1));
    }

    @Test
    void wordsOfCampaignsStayWords() throws IOException {
        String text = "world w\nvary who of " + NASTY + " other\nsample random 40\n";
        String page = CampaignPage.render(SampleCampaigns.report(NASTY, text));
        assertThat(page).doesNotContain(NASTY).doesNotContain("<b>");
        assertThat(data(page).at("/answer/campaign").asText()).isEqualTo(NASTY);
        assertThat(data(page).at("/maps/0/columns/0").asText()).isEqualTo(NASTY);
    }

    @Test
    void nothingIsLoaded() {
        String page =
                CampaignPage.render(SampleCampaigns.report("a", "world w\nsample random 1\n"));
        assertThat(page)
                .contains("default-src 'none'")
                .doesNotContain(" src=")
                .doesNotContain("@import")
                .doesNotContain("{{");
        assertThat(page.replace("http://www.w3.org/2000/svg", "")).doesNotContain("http:");
    }

    /** A million runs make no larger page than a few thousand. */
    @Tag("slow")
    @Test
    void aPageHasCountsAndNoRows() {
        String few = SampleCampaigns.COMPARED.replace("random 2000", "random 4000");
        String many = SampleCampaigns.COMPARED.replace("random 2000", "random 8000");
        int length = CampaignPage.render(SampleCampaigns.report("a", few)).length();
        assertThat(CampaignPage.render(SampleCampaigns.report("a", many)).length())
                .isLessThan(length * 11 / 10);
    }

    @Tag("slow")
    @Test
    void aResultIsTheSameForPrograms() throws IOException {
        CampaignReport report = SampleCampaigns.report("a", SampleCampaigns.COMPARED);
        JsonNode json = new ObjectMapper().readTree(CampaignJson.render(report));
        assertThat(json).isEqualTo(data(CampaignPage.render(report)).get("answer"));
        assertThat(json.get("runs").asLong()).isEqualTo(4000);
        assertThat(json.get("made").asLong() + json.get("impossible").asLong()).isEqualTo(4000);
        assertThat(json.at("/verdicts/0/subject").asText()).startsWith("collision below 0.2");
        assertThat(json.at("/events/0/bounds/0/value").asDouble()).isEqualTo(0.2);
        assertThat(json.at("/compared/worse").asLong()).isZero();
        assertThat(json.at("/compared/better").asLong()).isPositive();
        assertThat(json.at("/compared/firstBetter")).hasSize(20);
        assertThat(json.at("/coverage/taken").asInt()).isEqualTo(4);
        assertThat(json.at("/coverage/transitions").asInt()).isEqualTo(6);
        assertThat(json.at("/coverage/automata/1/transitions/4/number").asInt()).isEqualTo(5);
        assertThat(json.at("/coverage/automata/1/transitions/4/coded").asBoolean()).isFalse();
        assertThat(json.at("/coverage/automata/1/states/3/runs").asInt()).isZero();
        JsonNode parts = json.at("/coverage/automata/1/parts");
        assertThat(parts.findValuesAsText("part")).containsExactly("truck.driver", "van");
        assertThat(parts.at("/0/transitions/2").asLong()).isPositive();
        assertThat(parts.at("/1/transitions/2").asLong()).isZero();
        assertThat(parts.at("/1/number").asInt()).isEqualTo(14);
        assertThat(json.at("/coverage/automata/0/parts/0/number").asInt()).isZero();
        assertThat(json.at("/coverage/jars/0").asText()).isEqualTo("truck.jar");
        // Some never got there: the greatest time is none, and the histogram says how many.
        JsonNode reached = json.at("/measures/1");
        assertThat(reached.get("name").asText()).isEqualTo("reached");
        assertThat(reached.has("greatest")).isFalse();
        assertThat(reached.get("never").asLong()).isPositive();
    }

    @Test
    void aRunIsMadeAgainByACommand() throws IOException {
        CampaignReport report =
                SampleCampaigns.report(
                        "a", "world w\nvary who of it's $HOME\nseeds from 7\nsample random 1\n");
        JsonNode run =
                new ObjectMapper().readTree(CampaignJson.render(report)).at("/notable/0/command");
        assertThat(run.asText())
                .isIn(
                        "arcomat world models/yard/world/yard.world --seed 7 --set 'who=it'\\''s'"
                                + " --report build/run",
                        "arcomat world models/yard/world/yard.world --seed 7 --set 'who=$HOME'"
                                + " --report build/run");
    }

    /** What is worse than before turns the page red, although nothing was required. */
    @Tag("slow")
    @Test
    void olderTablesStandBeside() throws IOException {
        CampaignReport report = SampleCampaigns.against("a");
        JsonNode json = new ObjectMapper().readTree(CampaignJson.render(report));
        assertThat(json.get("verdict").asText()).isEqualTo("fails");
        assertThat(json.get("headline").asText()).endsWith(": something is worse than before");
        assertThat(json.at("/against/0/name").asText()).isEqualTo("build/careful");
        assertThat(json.at("/against/0/pairs").asLong()).isEqualTo(500);
        assertThat(json.at("/against/0/events/0/decision").asText()).isEqualTo("worse");
        assertThat(json.at("/against/0/events/0/better").asLong()).isZero();
        assertThat(json.at("/against/0/events/0/firstWorse")).hasSize(20);
        assertThat(json.at("/against/1/pairs").asLong()).isZero();
        assertThat(json.at("/against/1/events/0/decision").asText()).isEqualTo("undecided");
        assertThat(json.at("/against/1/remarks/0").asText()).contains("intervals decide");
    }
}
