package montiarc7;

import montiarc7.grammar.MontiArc7Parser.ArgumentContext;
import montiarc7.grammar.MontiArc7Parser.ComponentContext;
import montiarc7.grammar.MontiArc7Parser.ParameterContext;
import montiarc7.grammar.MontiArc7Parser.ParentContext;
import montiarc7.source.Lack;
import montiarc7.source.Lacks;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Checks that a component gives its parent what that one asks for: MontiArc passes nothing on. */
final class ParentArguments {
    private final ParentContext parent;
    private final List<ParameterContext> parameters;
    private final List<ArgumentContext> arguments;
    private final Set<String> features;
    private final Lacks lacks;

    /**
     * @param type of the parent
     * @param features that arguments may choose, too
     */
    ParentArguments(
            ParentContext parent, ComponentContext type, Set<String> features, Lacks lacks) {
        this.parent = parent;
        this.features = features;
        this.parameters = type.parameters() == null ? List.of() : type.parameters().parameter();
        this.arguments = parent.arguments() == null ? List.of() : parent.arguments().argument();
        this.lacks = lacks;
    }

    void check() {
        Set<String> names = new HashSet<>(features);
        parameters.forEach(each -> names.add(each.name().getText()));
        Set<String> given = new HashSet<>();
        for (int i = 0; i < arguments.size(); i++) {
            Optional<String> name = name(i);
            if (name.filter(names::contains).isEmpty()) {
                tell("has no parameter for '%s'; leave it out", arguments.get(i).getText());
            } else if (!given.add(name.get())) {
                tell("gets '%s' twice; leave one out", name.get());
            }
        }
        List<String> left = new ArrayList<>();
        for (ParameterContext each : parameters) {
            if (each.expression() == null && !given.contains(each.name().getText())) {
                left.add(each.name().getText());
            }
        }
        if (!left.isEmpty()) {
            tell("needs '%s'; give it behind 'extends'", String.join("', '", left));
        }
    }

    /** Of the parameter that an argument is for; nothing where there are more arguments. */
    private Optional<String> name(int argument) {
        ArgumentContext given = arguments.get(argument);
        if (given.name() != null) {
            return Optional.of(given.name().getText());
        }
        return argument < parameters.size()
                ? Optional.of(parameters.get(argument).name().getText())
                : Optional.empty();
    }

    private void tell(String what, String about) {
        lacks.missing(
                Lack.PARENTS,
                parent,
                ("'%s' " + what).formatted(parent.type().qname().getText(), about));
    }
}
