package arcomat.pipeline.campaign.measure;

import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.lower.Lowering;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Type;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.symbols.Workspace;
import arcomat.symbols.signatures.BehaviourReader;
import arcomat.syntax.Parsed;
import arcomat.syntax.Parser;
import arcomat.tree.Unit;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/** An expression as the body of a component, whose inputs are what can be read in the world. */
final class MeasureModel {
    static final String NO_EXPRESSION = "ARC1136";

    /** The type of what is true or not at a moment. */
    static final String CONDITION = "Boolean";

    /** The type of what is measured. */
    static final String NUMBER = "Double";

    /** Longer than the name of any brick. */
    private static final String VALUE = "valueOfThisExpression";

    private final Span expression;
    private final String type;
    private final Unit diagram;
    private final SourceFile file;
    private final int start;

    private MeasureModel(Span expression, String type, Unit diagram, SourceFile file, int start) {
        this.expression = expression;
        this.type = type;
        this.diagram = diagram;
        this.file = file;
        this.start = start;
    }

    /**
     * What became of it.
     *
     * @param component around the expression; absent where there are findings
     */
    record Read(Optional<Component> component, List<Diagnostic> findings) {
        /** The only expression of the component. */
        Expression expression() {
            return written(component.orElseThrow()).orElseThrow();
        }
    }

    /**
     * @param type that the expression is to have, as models write it; it needs no import
     */
    static Read read(Span expression, String type, Vocabulary vocabulary) {
        Unit diagram = Parser.parse(vocabulary.diagram()).unit().orElseThrow();
        boolean condition = type.equals(CONDITION);
        String head =
                """
                package %s;
                import %s.Readings.*;
                component Measure {
                timing instant;
                port %s out %s %s;
                automaton { state reading; initial reading; reading -> reading %s
                """
                        .formatted(
                                Vocabulary.PACKAGE,
                                Vocabulary.PACKAGE,
                                vocabulary.ports(),
                                type,
                                VALUE,
                                condition ? "[" : "/ {" + VALUE + " =");
        String tail = condition ? "\n] / {" + VALUE + " = true};}}\n" : "\n};}}\n";
        String text = head + expression.text() + tail;
        SourceFile file = new SourceFile("campaign/Measure.arc", text);
        return new MeasureModel(expression, type, diagram, file, head.length()).read();
    }

    private Read read() {
        Parsed parsed = Parser.parse(file);
        if (parsed.unit().isEmpty()) {
            return broken(parsed.findings().get(0));
        }
        Workspace workspace =
                Workspace.of(List.of(diagram, parsed.unit().get()), Set.of(), BehaviourReader.NONE);
        List<Diagnostic> errors =
                Checks.run(workspace, Profile.REQUIREMENTS).stream()
                        .filter(Diagnostic::isError)
                        .filter(each -> each.span().file().equals(file))
                        .toList();
        if (!errors.isEmpty()) {
            return broken(errors.get(0));
        }
        Component component =
                Lowering.lower(workspace).component(Vocabulary.PACKAGE + ".Measure").orElseThrow();
        return written(component).isPresent()
                ? new Read(Optional.of(component), List.of())
                : broken(noExpression());
    }

    private Diagnostic noExpression() {
        String what =
                switch (type) {
                    case NUMBER -> "number";
                    case CONDITION -> "condition";
                    default -> "value of type " + type;
                };
        return Diagnostic.error(
                NO_EXPRESSION,
                file.span(start, start + length()),
                "this is no expression for one %s that can be read at each moment".formatted(what));
    }

    /** The first one is enough: what follows may come from it. */
    private Read broken(Diagnostic finding) {
        return new Read(Optional.empty(), List.of(inCampaign(finding)));
    }

    private int length() {
        return expression.text().length();
    }

    /** The finding at its place in the campaign; what lies behind the expression is its end. */
    private Diagnostic inCampaign(Diagnostic finding) {
        int from = Math.max(0, Math.min(finding.span().start() - start, length()));
        int to = Math.max(from, Math.min(finding.span().end() - start, length()));
        int offset = expression.start();
        Span place = expression.file().span(offset + from, offset + to);
        return from == length()
                ? Diagnostic.error(NO_EXPRESSION, place, "here the expression should go on")
                : Diagnostic.error(finding.code(), place, finding.message());
    }

    /** Nothing, where what was written is more than an expression, or another thing. */
    private static Optional<Expression> written(Component component) {
        if (component.automata().size() != 1) {
            return Optional.empty();
        }
        Automaton automaton = component.automata().get(0);
        if (automaton.transitions().size() != 1 || automaton.states().size() != 1) {
            return Optional.empty();
        }
        Automaton.Transition only = automaton.transitions().get(0);
        List<Expression> sent =
                only.sends().stream().flatMap(each -> each.emission().values().stream()).toList();
        return only.guard()
                .or(() -> sent.size() == 1 ? Optional.of(sent.get(0)) : Optional.empty())
                .filter(MeasureModel::isValue);
    }

    /** Whether it is made of what can be read, and neither of whole robots nor of silence. */
    private static boolean isValue(Expression expression) {
        return expression.match(
                new Expression.SomeCases<>() {
                    @Override
                    public Boolean portRead(Expression.PortRead read) {
                        return !(read.type() instanceof Type.ClassType);
                    }

                    @Override
                    public Boolean portMatches(Expression.PortMatches matches) {
                        return false;
                    }

                    @Override
                    public Boolean attributeRead(Expression.AttributeRead read) {
                        return read.object() instanceof Expression.PortRead;
                    }

                    @Override
                    public Boolean otherwise(Expression other) {
                        return other.operands().stream().allMatch(MeasureModel::isValue);
                    }
                });
    }
}
