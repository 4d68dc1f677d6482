package arcomat.check.naming;

import arcomat.check.facts.Connections;
import arcomat.check.facts.MeantParts;
import arcomat.check.law.Check;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.VariableSymbol;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * ARC0201: ports, parameters, variables and instances of a component differ in name, inherited ones
 * included. A port or parameter that is inherited may be declared again. (Wor16 MU1)
 */
public final class MemberNamesUnique implements Check.OnComponent {

    private record Member(String kind, String name, Span place, String advice) {
        boolean mayReplace(Member inherited) {
            return kind.equals(inherited.kind) && (kind.equals("port") || kind.equals("parameter"));
        }
    }

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        Map<String, Member> inherited = new HashMap<>();
        for (ComponentSymbol ancestor : component.lineage()) {
            if (ancestor != component) {
                for (Member member : members(ancestor)) {
                    inherited.putIfAbsent(member.name(), member);
                }
            }
        }
        Map<String, Member> own = new HashMap<>();
        for (Member member : members(component)) {
            Member other = inherited.get(member.name());
            if (other == null || member.mayReplace(other)) {
                other = own.putIfAbsent(member.name(), member);
            }
            if (other != null) {
                report(component, member, other, findings);
            }
        }
    }

    private static void report(
            ComponentSymbol component, Member member, Member other, Findings findings) {
        findings.report(
                        member.place(),
                        "component '%s' has a %s '%s' already; %s",
                        component.name(),
                        other.kind(),
                        member.name(),
                        member.advice())
                .related(other.place(), "the " + other.kind() + " '" + other.name() + "'");
    }

    private static List<Member> members(ComponentSymbol component) {
        List<Member> members = new ArrayList<>();
        for (ParameterSymbol each : component.signature().ownParameters()) {
            members.add(member("parameter", each.name(), each.nameSpan(), true));
        }
        for (PortSymbol each : component.signature().ownPorts()) {
            members.add(member("port", each.name(), each.nameSpan(), !each.implicit()));
        }
        for (VariableSymbol each : component.signature().ownVariables()) {
            if (!MeantParts.isNamed(each.name(), component)) {
                members.add(member("variable", each.name(), each.nameSpan(), true));
            }
        }
        // A misspelled part may be meant to use an inner component that seems unused.
        boolean lacksPart = Connections.lacksPart(component);
        for (InstanceSymbol each : component.ownInstances()) {
            boolean isNamed = each.origin() == InstanceSymbol.Origin.NAMED;
            if (!lacksPart || each.origin() != InstanceSymbol.Origin.AUTOMATIC) {
                members.add(member("part", each.name(), each.nameSpan(), isNamed));
            }
        }
        return members;
    }

    private static Member member(String kind, String name, Span place, boolean isNamed) {
        String advice =
                isNamed
                        ? "rename this " + kind
                        : "give this " + kind + " a name, or it is named after its type";
        return new Member(kind, name, place, advice);
    }
}
