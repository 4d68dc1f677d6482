package arcomat.report.finding;

import arcomat.report.text.Fields;
import arcomat.report.text.Style;

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
            Pattern.compile("# [A-Z]+[0-9]{4} (?<title>.*)\n+(?<first>(?:.+\n)*)");

    static SarifRules of(List<Reported> results, Function<String, Optional<String>> pages) {
        return new SarifRules(
                results.stream().map(each -> each.finding().code()).sorted().distinct().toList(),
                pages);
    }

    int index(String code) {
        return codes.indexOf(code);
    }

    List<Fields> all(List<Reported> results) {
        return codes.stream().map(code -> rule(code, level(code, results))).toList();
    }

    private Fields rule(String code, String level) {
        Optional<String> page = pages.apply(code);
        Optional<Matcher> parts = page.map(PAGE::matcher).filter(Matcher::lookingAt);
        Optional<String> title = parts.map(each -> each.group("title"));
        Optional<String> first = parts.map(each -> each.group("first").strip().replace('\n', ' '));
        return Fields.of("id", code)
                .with("shortDescription", title.map(text -> Fields.of("text", text)))
                .with("fullDescription", first.map(text -> Fields.of("text", text)))
                .with("help", page.map(SarifRules::help))
                .with("defaultConfiguration", Fields.of("level", level));
    }

    private static Fields help(String page) {
        return Fields.of("text", FindingsText.explanation(page, Style.PLAIN))
                .with("markdown", page);
    }

    /** Of the worst finding: a law that is an error for code may be a warning before. */
    private static String level(String code, List<Reported> results) {
        boolean error =
                results.stream()
                        .map(Reported::finding)
                        .anyMatch(each -> each.code().equals(code) && each.isError());
        return error ? "error" : "warning";
    }
}
