package arcomat.report.finding;

import arcomat.report.text.Style;
import arcomat.source.Diagnostic;

import java.util.List;
import java.util.Map;
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

    record Rule(
            String id,
            Optional<Map<String, String>> shortDescription,
            Optional<Map<String, String>> fullDescription,
            Optional<Help> help,
            Map<String, String> defaultConfiguration) {}

    record Help(String text, String markdown) {
        static Help of(String page) {
            return new Help(ExplanationText.render(page, Style.PLAIN), page);
        }
    }

    static SarifRules of(List<Reported> results, Function<String, Optional<String>> pages) {
        return new SarifRules(
                results.stream().map(each -> each.finding().code()).sorted().distinct().toList(),
                pages);
    }

    int index(String code) {
        return codes.indexOf(code);
    }

    List<Rule> all(List<Reported> results) {
        return codes.stream().map(code -> rule(code, level(code, results))).toList();
    }

    private Rule rule(String code, String level) {
        Optional<String> page = pages.apply(code);
        Optional<Matcher> parts = page.map(PAGE::matcher).filter(Matcher::lookingAt);
        return new Rule(
                code,
                parts.map(each -> text(each.group("title"))),
                parts.map(each -> text(each.group("first").strip().replace('\n', ' '))),
                page.map(Help::of),
                Map.of("level", level));
    }

    private static Map<String, String> text(String text) {
        return Map.of("text", text);
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
}
