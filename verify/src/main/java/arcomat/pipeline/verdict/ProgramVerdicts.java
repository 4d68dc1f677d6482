package arcomat.pipeline.verdict;

import arcomat.model.Component;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.generate.GenerateCode;
import arcomat.pipeline.generate.RobotBuilder.BrickProgram;
import arcomat.pipeline.verdict.TextVerdict.Sheet;
import arcomat.pipeline.verdict.TextVerdict.Tone;
import arcomat.report.brick.BrickReportText;
import arcomat.report.finding.FindingsText;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;
import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What becomes of components on the brick, each at the name of one that is to be deployed. */
record ProgramVerdicts(LoweredModels models, Session session) {
    private static final String FILE = "generate.txt";

    /** Programs are made one after the other, and who has given up asking is noticed in between. */
    List<TextVerdict> at(List<VerdictPlace> places) {
        List<TextVerdict> verdicts = new ArrayList<>();
        for (VerdictPlace place : places) {
            if (place.kind() == VerdictPlace.Kind.PROGRAM) {
                component(place).map(each -> verdict(place, each)).ifPresent(verdicts::add);
            }
        }
        return verdicts;
    }

    /** None has the name where it takes types that nobody says. */
    private Optional<String> component(VerdictPlace place) {
        return models.model().components().stream()
                .filter(each -> each.span().equals(place.subject()))
                .map(Component::qualifiedName)
                .findFirst();
    }

    private TextVerdict verdict(VerdictPlace place, String component) {
        try {
            CheckedAnswer<BrickProgram> made =
                    GenerateCode.program(component, models.checked().loaded(), session);
            List<Diagnostic> findings = made.check().findings();
            return made.value()
                    .map(program -> fitting(place, program, findings))
                    .orElseGet(() -> refused(place, findings));
        } catch (WrongUse reason) {
            return refused(place, String.valueOf(reason.getMessage()), "");
        }
    }

    private static TextVerdict fitting(
            VerdictPlace place, BrickProgram program, List<Diagnostic> findings) {
        String table = BrickReportText.render(program.report(), Style.PLAIN);
        return new TextVerdict(
                place,
                Tone.OPEN,
                BrickReportText.line(program.report()),
                new Sheet(FILE, () -> table + FindingsText.render(findings, Style.PLAIN)));
    }

    private static TextVerdict refused(VerdictPlace place, List<Diagnostic> findings) {
        List<Diagnostic> errors = findings.stream().filter(Diagnostic::isError).toList();
        return refused(place, errors.get(0).message(), FindingsText.render(errors, Style.PLAIN));
    }

    private static TextVerdict refused(VerdictPlace place, String reason, String all) {
        String line = "no jar: " + reason;
        return new TextVerdict(
                place,
                Tone.BAD,
                Printable.escape(line),
                new Sheet(FILE, () -> all.isEmpty() ? line + "\n" : all));
    }
}
