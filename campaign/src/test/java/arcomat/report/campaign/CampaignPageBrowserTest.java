package arcomat.report.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.WriteCampaignPage;
import arcomat.report.page.BrowserTest;

import org.junit.jupiter.api.function.Executable;
import org.openqa.selenium.Keys;

import java.nio.file.Path;
import java.util.Map;

/** The page of a campaign in a browser: figures, the map with its keys, commands. */
class CampaignPageBrowserTest extends BrowserTest {
    @Override
    protected Map<String, Executable> tests() {
        return Map.of(
                "what a campaign found",
                this::look,
                "what is rare, and worst",
                this::search,
                "older tables beside it",
                this::beside);
    }

    private void search() throws WrongUse {
        CampaignReport report = SampleCampaigns.searched("yard.campaign");
        Session session = Session.in(Path.of(""), Progress.NONE);
        session.run(new WriteCampaignPage(report, folder.toString()));
        browser.open(folder.resolve("index.html").toUri().toString(), "#runs li");
        browser.resize(1500, 2700);
        assertThat(browser.text("#rare .said")).contains("distance of 20 mm: probability 0.1");
        assertThat(browser.findAll("#rare .estimate")).hasSize(4);
        assertThat(browser.text("#rare code")).startsWith("arcomat world models/yard");
        assertThat(browser.text("#worst .said"))
                .contains("smallest distance", "320 runs, 8 of them without", "31.4", "1 time");
        assertThat(browser.findAll("#worst .generation")).hasSize(39);
        assertThat(browser.text("#worst code")).startsWith("arcomat world models/yard");
        browser.picture("campaign-search");
        narrow();
    }

    private void look() throws WrongUse {
        CampaignReport report = SampleCampaigns.report("yard.campaign", SampleCampaigns.COMPARED);
        Session session = Session.in(Path.of(""), Progress.NONE);
        session.run(new WriteCampaignPage(report, folder.toString()));
        browser.open(folder.resolve("index.html").toUri().toString(), "#runs li");
        browser.resize(1500, 2700); // all of it
        says();
        browser.picture("campaign");
        map();
        narrow();
        browser.wear("dark");
        browser.picture("campaign-dark");
        browser.wear("light");
        browser.print();
        assertThat(browser.find("#heat .toolbar").isDisplayed()).isFalse();
        browser.picture("campaign-print");
    }

    private void beside() throws WrongUse {
        Session session = Session.in(Path.of(""), Progress.NONE);
        CampaignReport report = SampleCampaigns.against("yard.campaign");
        session.run(new WriteCampaignPage(report, folder.toString()));
        browser.open(folder.resolve("index.html").toUri().toString(), "#against-1 .beside");
        browser.resize(1500, 2700);
        assertThat(browser.text("#against-0")).contains("build/careful", "collision", "worse");
        assertThat(browser.findAll("#against-0 tr.bad")).isNotEmpty();
        assertThat(browser.findAll("#against-1 tr.bad")).isEmpty();
        browser.find("#against-0 details summary").click();
        assertThat(browser.text("#against-0 details")).contains("got worse", "seed ");
        browser.picture("campaign-against");
        narrow();
    }

    private void says() {
        assertThat(browser.text(".headline")).contains("requirements fail");
        assertThat(browser.findAll("#verdicts li")).hasSize(4);
        assertThat(browser.text("#events")).contains("collision", "surely");
        assertThat(browser.findAll("#events .estimate")).hasSize(4);
        assertThat(browser.findAll("#measures figure")).hasSize(7);
        assertThat(browser.text("#measures")).contains("never in", "No run has a number");
        assertThat(browser.text("#compared")).contains("Got better: the first 20 of", "None.");
        assertThat(browser.findAll("#coverage details")).hasSize(2);
        assertThat(browser.findAll("#coverage details[open]")).hasSize(1);
        assertThat(browser.findAll("#coverage .missing")).hasSize(3);
        assertThat(browser.findAll("#coverage .never")).hasSize(2);
        assertThat(browser.text("#coverage .never")).isEqualTo("van: none");
        assertThat(browser.text("#coverage"))
                .contains("truck.driver: ", "by each part", "6 of 11 transitions, 6 of 9 states");
        assertThat(browser.text("#coverage"))
                .contains("4 of 6", "state lost", "another one is always taken first", "truck.jar");
        assertThat(browser.text("#runs code")).startsWith("arcomat world models/yard");
    }

    private void map() {
        int cells = browser.findAll(".heat tbody td").size();
        assertThat(cells).isEqualTo(10 * 10);
        browser.run("document.querySelector('.heat td[tabindex=\"0\"]').focus()");
        browser.press(Keys.ARROW_DOWN, Keys.ARROW_RIGHT);
        assertThat(browser.text(".readout")).startsWith("speed ").contains("light ", " of ");
        choose("question", "distance");
        choose("part", "least");
        assertThat(browser.findAll(".heat tbody td.amount")).isNotEmpty();
        choose("y", "speed");
        assertThat(browser.text(".heat caption")).startsWith("light across, speed upwards");
        choose("x", "driver");
        assertThat(browser.findAll(".heat tfoot th")).hasSize(2);
        browser.picture("campaign-map");
        choose("x", "light");
        choose("question", "collision");
    }

    private void choose(String field, String value) {
        browser.find("#heat-" + field + " option[value='" + value + "']").click();
    }

    /** On a telephone nothing sticks out. */
    private void narrow() {
        Object wide = browser.run("return document.documentElement.scrollWidth - innerWidth");
        assertThat((Long) wide).isLessThanOrEqualTo(0);
        browser.resize(390, 1200);
        Object narrow = browser.run("return document.documentElement.scrollWidth - innerWidth");
        browser.resize(390, 5200);
        browser.picture("campaign-narrow");
        assertThat((Long) narrow).isLessThanOrEqualTo(0);
        browser.resize(1500, 2700);
    }
}
