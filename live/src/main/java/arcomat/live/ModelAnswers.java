package arcomat.live;

import arcomat.live.json.JsonText;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.pipeline.check.LoweredModels;
import arcomat.source.Diagnostic;
import arcomat.source.Fix;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** What the page shows of models: findings at their places, and the components there are. */
final class ModelAnswers {
    private ModelAnswers() {}

    /**
     * @param further findings, about what lies beside the models
     */
    static String findings(OpenModels models, List<Diagnostic> further) {
        List<Diagnostic> findings = new ArrayList<>(models.checked().findings());
        findings.addAll(further);
        return JsonText.object(
                json -> {
                    json.objects("findings", findings, ModelAnswers::finding);
                    json.field("meant", models.checked().suppressed().size());
                    json.field("whole", models.areWhole());
                });
    }

    static String components(LoweredModels shown) {
        return JsonText.object(
                json -> json.objects("components", shown.named(), ModelAnswers::component));
    }

    static void place(JsonText json, Span span) {
        json.field("path", span.file().path());
        json.field("line", span.startPosition().line());
        json.field("start", span.start());
        json.field("end", span.end());
    }

    private static void finding(JsonText json, Diagnostic finding) {
        place(json, finding.span());
        json.field("code", finding.code());
        json.field("severity", finding.severity().name().toLowerCase(Locale.ROOT));
        json.field("message", finding.message());
        json.objects(
                "related",
                finding.related(),
                (each, related) -> {
                    place(each, related.span());
                    each.field("note", related.note());
                });
        finding.fix().ifPresent(fix -> json.field("fix", each -> fix(each, fix)));
    }

    private static void fix(JsonText json, Fix fix) {
        json.field("title", fix.title());
        json.objects("edits", fix.edits(), ModelAnswers::edit);
    }

    static void edit(JsonText json, Fix.TextEdit edit) {
        place(json, edit.span());
        json.field("text", edit.text());
    }

    private static void component(JsonText json, Component component) {
        json.field("name", component.qualifiedName());
        place(json, component.span());
        json.field("composite", component.isComposite());
        json.field("platform", component.platform());
        json.field("arguments", !component.hasDefaults());
        json.objects("automata", component.automata(), ModelAnswers::automaton);
    }

    private static void automaton(JsonText json, Automaton automaton) {
        json.field("name", automaton.name());
        json.strings("states", automaton.states());
        place(json, automaton.span());
    }

    /** A sentence in the place of an answer. */
    static String refusal(String reason) {
        return JsonText.object(json -> json.field("refused", reason));
    }
}
