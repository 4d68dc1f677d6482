package arcomat.report.finding;

import arcomat.report.text.Style;
import arcomat.source.Diagnostic;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The laws that some findings break, as SARIF writes rules: with the pages that explain them.
 *
 * @param codes sorted; the index of a code is the index of its rule
 * @param pages the page of a code in Markdown
 */
record SarifRules(List<String> codes, Function<String, Optional<String>> pages) {
    private static final Pattern PAGE =
            Pattern.compile("# ARC[0-9]{4} (?<title>.*)\n+(?<first>(?:.+\n)*)");

    static SarifRules of(List<Reported> results, Function<String, Optional<String>> pages) {
        return new SarifRules(
                results.stream().map(each -> each.finding().code()).sorted().distinct().toList(),
                pages);
    }

    int index(String code) {
        return codes.indexOf(code);
    }

    /** The field {@code rules}. */
    void write(JsonGenerator json, List<Reported> results) throws IOException {
        json.writeArrayFieldStart("rules");
        for (String code : codes) {
            json.writeStartObject();
            json.writeStringField("id", code);
            Optional<String> page = pages.apply(code);
            if (page.isPresent()) {
                writePage(json, page.get());
            }
            json.writeObjectFieldStart("defaultConfiguration");
            json.writeStringField("level", level(code, results));
            json.writeEndObject();
            json.writeEndObject();
        }
        json.writeEndArray();
    }

    /** Of the worst finding: a law that is an error for code may be a warning before. */
    private static String level(String code, List<Reported> results) {
        boolean error =
                results.stream()
                        .map(Reported::finding)
                        .anyMatch(each -> each.code().equals(code) && each.isError());
        return error ? "error" : "warning";
    }

    static String level(Diagnostic finding) {
        return FindingsText.word(finding.severity());
    }

    private static void writePage(JsonGenerator json, String page) throws IOException {
        Matcher parts = PAGE.matcher(page);
        if (parts.lookingAt()) {
            writeText(json, "shortDescription", parts.group("title"));
            writeText(json, "fullDescription", parts.group("first").strip().replace('\n', ' '));
        }
        json.writeObjectFieldStart("help");
        json.writeStringField("text", ExplanationText.render(page, Style.PLAIN));
        json.writeStringField("markdown", page);
        json.writeEndObject();
    }

    private static void writeText(JsonGenerator json, String field, String text)
            throws IOException {
        json.writeObjectFieldStart(field);
        json.writeStringField("text", text);
        json.writeEndObject();
    }
}
