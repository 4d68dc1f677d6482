package arcomat.symbols.occurrences;

import arcomat.source.ArrayNames;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.GivenArgument;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.TypedExpression;
import arcomat.symbols.expressions.Unfolded;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.occurrences.Occurrence.Role;
import arcomat.tree.Expression;
import arcomat.tree.Name;
import arcomat.tree.TypeReference;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;

/**
 * Names in expressions.
 *
 * @param types what types mean at the place
 * @param component the component whose parts may be named, if one may
 */
record ExpressionPlaces(
        NamePlaces places,
        Function<TypeReference, Resolution<TypeSymbol>> types,
        Optional<ComponentSymbol> component)
        implements TypedExpression.Cases<ExpressionPlaces> {

    /** The same, taken down elsewhere. */
    ExpressionPlaces to(NamePlaces others) {
        return new ExpressionPlaces(others, types, component);
    }

    void in(Typed typed) {
        in(typed, any -> true);
    }

    /** Only at some places. */
    void in(Typed typed, Predicate<Expression> wanted) {
        typed.expression()
                .walk(
                        each -> {
                            if (wanted.test(each.node())) {
                                each.match(this);
                            }
                        });
        unfolded(typed.unfolded());
    }

    private void unfolded(Unfolded unfolded) {
        unfolded.values().forEach(value -> value.walk(each -> each.match(this)));
        unfolded.types().forEach(type -> places.type(type, types));
        unfolded.names()
                .forEach(each -> places.declared(each.name().span(), new Referent.Bound(each)));
        unfolded.reads()
                .forEach(
                        each ->
                                places.add(
                                        each.place(),
                                        new Referent.Bound(each.bound()),
                                        Role.READS));
    }

    void in(List<Typed> typed) {
        typed.forEach(this::in);
    }

    void arguments(List<GivenArgument> given) {
        for (GivenArgument each : given) {
            in(each.value());
            each.node().name().ifPresent(name -> parameter(name, each.parameter()));
        }
    }

    private void parameter(Name name, Optional<ParameterSymbol> meant) {
        meant.ifPresent(
                found -> places.add(name.span(), new Referent.Parameter(found), Role.REFERS));
    }

    private static List<Name> names(Expression node) {
        return node instanceof Expression.Reference reference
                ? reference.name().parts()
                : List.of();
    }

    /** Where a name stands for it that the expression has given, there is no place of its own. */
    private ExpressionPlaces read(Expression node, Referent value) {
        names(node).stream()
                .findFirst()
                .filter(name -> isNamed(name.text(), value.name()))
                .ifPresent(name -> places.add(name.span(), value, Role.READS));
        return this;
    }

    /** A whole array is named by a quantifier that is about its elements. */
    private static boolean isNamed(String written, String name) {
        return written.equals(name)
                || ArrayNames.isElement(name) && written.equals(ArrayNames.array(name));
    }

    /** Where a part's port is meant, its symbol has the names of both. */
    private ExpressionPlaces port(Expression node, PortSymbol port) {
        if (port.name().indexOf('.') < 0) {
            return read(node, new Referent.Port(port));
        }
        List<Name> names = names(node);
        component
                .filter(whole -> names.size() > 1)
                .flatMap(whole -> whole.instance(names.get(0).text()))
                .ifPresent(part -> partAndPort(names, part));
        return this;
    }

    private void partAndPort(List<Name> names, InstanceSymbol part) {
        places.add(names.get(0).span(), new Referent.Part(part), Role.REFERS);
        part.port(names.get(1).text())
                .ifPresent(
                        port ->
                                places.add(
                                        names.get(1).span(), new Referent.Port(port), Role.READS));
    }

    @Override
    public ExpressionPlaces literal(TypedExpression.Literal literal) {
        return this;
    }

    @Override
    public ExpressionPlaces constant(TypedExpression.Constant constant) {
        places.path(
                names(constant.node()), new Referent.Constant(constant.type(), constant.ordinal()));
        return this;
    }

    @Override
    public ExpressionPlaces portRead(TypedExpression.PortRead read) {
        return port(read.node(), read.port());
    }

    @Override
    public ExpressionPlaces variableRead(TypedExpression.VariableRead read) {
        return read(read.node(), new Referent.Variable(read.variable()));
    }

    @Override
    public ExpressionPlaces parameterRead(TypedExpression.ParameterRead read) {
        return read(read.node(), new Referent.Parameter(read.parameter()));
    }

    /** Of {@code a.b.c}, each attribute is a read of its own; all have the whole for their text. */
    @Override
    public ExpressionPlaces attributeRead(TypedExpression.AttributeRead read) {
        List<Name> names = names(read.node());
        ClassSymbol type = (ClassSymbol) read.object().type();
        places.add(
                names.get(position(read)).span(),
                new Referent.Attribute(type.attributes().get(read.index())),
                Role.READS);
        return this;
    }

    /** The number of names in front of it. */
    private static int position(TypedExpression.AttributeRead read) {
        if (read.object().node() != read.node()) {
            return 1; // the value of a name that is bound elsewhere
        }
        return read.object() instanceof TypedExpression.AttributeRead inner
                ? position(inner) + 1
                : width(read.object());
    }

    /** How many names a value takes. */
    private static int width(TypedExpression value) {
        return value instanceof TypedExpression.PortRead read
                        && read.port().name().indexOf('.') >= 0
                ? 2
                : 1;
    }

    @Override
    public ExpressionPlaces absence(TypedExpression.Absence absence) {
        return port(absence.node().operand(), absence.port());
    }

    @Override
    public ExpressionPlaces cast(TypedExpression.Cast cast) {
        places.type(cast.node().type(), types);
        return this;
    }

    @Override
    public ExpressionPlaces newObject(TypedExpression.NewObject object) {
        List<Name> names = new ArrayList<>();
        object.node().target().ifPresent(target -> names.addAll(names(target)));
        names.add(object.node().name());
        NamePlaces.referent(object.type()).ifPresent(type -> places.path(names, type));
        return this;
    }

    @Override
    public ExpressionPlaces unary(TypedExpression.Unary unary) {
        return this;
    }

    @Override
    public ExpressionPlaces binary(TypedExpression.Binary binary) {
        return this;
    }

    @Override
    public ExpressionPlaces conditional(TypedExpression.Conditional conditional) {
        return this;
    }

    @Override
    public ExpressionPlaces membership(TypedExpression.Membership membership) {
        return this;
    }

    @Override
    public ExpressionPlaces erroneous(TypedExpression.Erroneous erroneous) {
        return this;
    }
}
