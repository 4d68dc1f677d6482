package arcomat.check.stereotypes;

import arcomat.check.law.Carrier;
import arcomat.check.law.Check;
import arcomat.source.Fix;
import arcomat.source.Nearest;
import arcomat.source.Span;
import arcomat.tree.Name;
import arcomat.tree.Stereotype;

import java.util.List;

/** ARC0502: a stereotype has a value that it knows, or none if it takes none. */
public final class StereotypeValue implements Check.OnStereotype {

    @Override
    public void check(Stereotype stereotype, Carrier carrier, Context context, Findings findings) {
        KnownStereotype.find(stereotype.name().text())
                .filter(known -> known.carriers().contains(carrier))
                .ifPresent(known -> check(stereotype, known, findings));
    }

    private static void check(Stereotype stereotype, KnownStereotype known, Findings findings) {
        switch (known.form()) {
            case FLAG -> checkFlag(stereotype, findings);
            case CHOICE -> checkChoice(stereotype, known, findings);
            case COUNT -> checkCount(stereotype, findings);
            case REASON ->
                    checkText(
                            stereotype,
                            "\\s*\\S.*",
                            "a reason, as in <<%s = \"reason\">>",
                            findings);
            case NAME_AND_REASON ->
                    checkText(
                            stereotype,
                            "\\s*[^:\\s]+\\s*:\\s*\\S.*",
                            "the name of a component that is gone and a reason, as in"
                                    + " <<%s = \"p.Robot: reason\">>",
                            findings);
            case MESSAGE, TEXT -> {}
        }
    }

    private static void checkFlag(Stereotype stereotype, Findings findings) {
        if (stereotype.value().isPresent()) {
            Span name = stereotype.name().span();
            Span all = stereotype.span();
            findings.report(
                            stereotype.value().get(),
                            "stereotype '%s' takes no value; delete it",
                            stereotype.name())
                    .fix(
                            Fix.replace(
                                    "Delete the value",
                                    new Span(all.file(), name.end(), all.end()),
                                    ""));
        }
    }

    private static void checkChoice(
            Stereotype stereotype, KnownStereotype known, Findings findings) {
        if (stereotype.value().isEmpty()) {
            findings.report(
                    stereotype,
                    "stereotype '%s' needs a value: %s",
                    known.name(),
                    list(known.values()));
        } else if (!known.values().contains(stereotype.value().get().text())) {
            reportUnknown(stereotype.value().get(), known, findings);
        }
    }

    private static void reportUnknown(Name value, KnownStereotype known, Findings findings) {
        findings.report(
                value,
                "stereotype '%s' has no value '%s'; it can be %s",
                known.name(),
                value,
                list(known.values()));
        Nearest.to(value.text(), known.values())
                .ifPresent(
                        nearest ->
                                findings.fix(
                                        Fix.replace(
                                                "Replace '" + value + "' by '" + nearest + "'",
                                                value.span(),
                                                '"' + nearest + '"')));
    }

    private static void checkCount(Stereotype stereotype, Findings findings) {
        String value = stereotype.value().map(Name::text).orElse("");
        if (!value.matches("[1-9][0-9]{0,5}")) {
            findings.report(
                    stereotype,
                    "stereotype '%s' needs a whole number from 1 to 999999 as its value",
                    stereotype.name());
        }
    }

    private static void checkText(
            Stereotype stereotype, String form, String example, Findings findings) {
        if (!stereotype.value().map(Name::text).orElse("").matches(form)) {
            findings.report(
                    stereotype,
                    "stereotype '%s' needs %s",
                    stereotype.name(),
                    example.formatted(stereotype.name()));
        }
    }

    /** {@code "chaos", "output" or "ignore"}. */
    private static String list(List<String> values) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < values.size(); i++) {
            String separator = i == 0 ? "" : i == values.size() - 1 ? " or " : ", ";
            text.append(separator).append('"').append(values.get(i)).append('"');
        }
        return text.toString();
    }
}
