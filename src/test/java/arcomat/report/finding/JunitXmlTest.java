package arcomat.report.finding;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.report.finding.JunitXml.Case;
import arcomat.report.finding.JunitXml.Case.Outcome;
import arcomat.report.text.Printable;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.xml.sax.InputSource;

import java.io.StringReader;
import java.util.List;
import java.util.Optional;

import javax.xml.parsers.DocumentBuilderFactory;

class JunitXmlTest {
    private static final Span PLACE = new SourceFile("a/B.mt", "one\ntwo\n").span(4, 7);

    private static Case failed(String group, String name, String message, String details) {
        return new Case(group, name, Optional.of(PLACE), Outcome.FAILED, message, details);
    }

    private static Element parsed(String xml) throws Exception {
        var builder = DocumentBuilderFactory.newInstance().newDocumentBuilder();
        builder.setErrorHandler(null); // says what is wrong by its exception alone
        Document document = builder.parse(new InputSource(new StringReader(xml)));
        return document.getDocumentElement();
    }

    private static Element first(Element parent, String name) {
        return (Element) parent.getElementsByTagName(name).item(0);
    }

    @Test
    void casesStandInTheirGroupsWithTheirPlaces() throws Exception {
        Case undecided =
                new Case("g", "c", Optional.empty(), Outcome.UNDECIDED, "no time left", "");
        List<Case> cases = List.of(failed("g", "a", "no", "why"), failed("h", "b", "no", "why"));
        Element root =
                parsed(JunitXml.render("all", List.of(cases.get(0), cases.get(1), undecided)));
        assertThat(root.getAttribute("tests")).isEqualTo("3");
        assertThat(root.getAttribute("failures")).isEqualTo("2");
        assertThat(root.getAttribute("errors")).isEqualTo("1");
        assertThat(root.getElementsByTagName("testsuite").getLength()).isEqualTo(2);
        Element test = first(root, "testcase");
        assertThat(test.getAttribute("file")).isEqualTo("a/B.mt");
        assertThat(test.getAttribute("line")).isEqualTo("2");
        assertThat(first(test, "failure").getTextContent()).isEqualTo("why");
        assertThat(first(root, "error").getAttribute("message")).isEqualTo("no time left");
    }

    @Test
    void charactersThatXmlCannotWriteAreToldInWords() throws Exception {
        Element root =
                parsed(
                        JunitXml.render(
                                "a", List.of(failed("<g>", "\u0007\"", "]]>\n", "\u0000&\ud800"))));
        Element test = first(root, "testcase");
        assertThat(test.getAttribute("classname")).isEqualTo("<g>");
        assertThat(test.getAttribute("name")).isEqualTo("\\u0007\"");
        assertThat(first(test, "failure").getAttribute("message")).isEqualTo("]]>\\u000a");
        assertThat(first(test, "failure").getTextContent()).isEqualTo("\\u0000&\\ud800");
    }

    @Property
    void isWellFormedWhateverNamesContain(
            @ForAll String group,
            @ForAll String name,
            @ForAll String message,
            @ForAll String details)
            throws Exception {
        Element root =
                parsed(JunitXml.render(name, List.of(failed(group, name, message, details))));
        assertThat(first(root, "testcase").getAttribute("name")).isEqualTo(Printable.escape(name));
    }
}
