package arcomat.report.page;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.report.page.Page.Tone;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.Base64;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** What can be said about a page without a browser. */
class PageTextTest {
    @Test
    void thePolicyNamesTheVeryScriptAndStyle() throws Exception {
        String page = PageText.render(SamplePages.hostile());
        assertThat(page)
                .contains("style-src 'sha256-" + hash(between(page, "<style>", "</style>")) + "'")
                .contains(
                        "script-src 'sha256-" + hash(between(page, "<script>", "</script>")) + "'")
                .contains("default-src 'none'");
    }

    private static String hash(String text) throws Exception {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        return Base64.getEncoder()
                .encodeToString(MessageDigest.getInstance("SHA-256").digest(bytes));
    }

    @Test
    void theScriptIsTheSameWhateverModelsSay() {
        assertThat(between(PageText.render(SamplePages.hostile()), "<script>", "</script>"))
                .isEqualTo(between(PageText.render(SamplePages.small()), "<script>", "</script>"));
    }

    @Test
    void nothingOfAModelBeginsATag() {
        String page = PageText.render(SamplePages.hostile());
        assertThat(page).doesNotContain("<img", "<!--", "<svg", "window.hacked=1>");
        assertThat(count(page, "<script")).isEqualTo(2);
        assertThat(count(page, "</script")).isEqualTo(2);
    }

    @Test
    void thePageCanBeEncoded() {
        String page = PageText.render(SamplePages.hostile());
        assertThat(new String(page.getBytes(StandardCharsets.UTF_8), StandardCharsets.UTF_8))
                .isEqualTo(page);
    }

    @Test
    void nothingIsLoaded() {
        String page = PageText.render(SamplePages.small());
        assertThat(page).doesNotContain("src=\"", "href=", "@import", "url(");
    }

    @Test
    void tracksAreWrittenAsRunLengths() throws IOException {
        JsonNode data = data(SamplePages.small());
        JsonNode tracks = data.at("/stories/0/tracks");
        assertThat(tracks.at("/0/values")).hasToString("[\"fwd\"]");
        assertThat(tracks.at("/0/runs")).hasToString("[0,1,-1,2,0,1,-1,2,0,1,-1,2,0,1]");
        assertThat(tracks.at("/1/runs")).hasToString("[0,5,1,5]");
        assertThat(tracks.at("/1/elements")).hasToString("[[\"state 0\"],[\"state 1\"]]");
    }

    @Test
    void theSamePictureIsThereOnce() {
        Page page = SamplePages.small();
        Story story = page.stories().get(0);
        Page twice = new Page("test", "p", Tone.BAD, "", java.util.List.of(story, story));
        assertThat(count(PageText.render(twice), "<template")).isEqualTo(1);
    }

    @Test
    void textsAreEscapedAsOnAConsole() throws IOException {
        JsonNode title = data(SamplePages.hostile()).at("/stories/7/title");
        assertThat(title.asText()).isEqualTo("\\u202egnp\\ud800\\u0000\\u2028");
    }

    private static JsonNode data(Page page) throws IOException {
        return new ObjectMapper()
                .readTree(
                        between(
                                PageText.render(page),
                                "<script type=\"application/json\" id=\"data\">",
                                "</script>"));
    }

    private static String between(String text, String begin, String end) {
        Matcher matcher =
                Pattern.compile(Pattern.quote(begin) + "(.*?)" + Pattern.quote(end), Pattern.DOTALL)
                        .matcher(text);
        assertThat(matcher.find()).isTrue();
        return matcher.group(1);
    }

    private static int count(String text, String wanted) {
        return text.split(Pattern.quote(wanted), -1).length - 1;
    }
}
