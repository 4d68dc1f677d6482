package arcomat.symbols.occurrences;

import arcomat.source.ArrayNames;
import arcomat.source.Span;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.StateSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.bodies.InvariantSymbol;
import arcomat.symbols.bodies.StreamTestSymbol;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.Unfolded;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.ClassSymbol.AttributeSymbol;
import arcomat.symbols.names.DefinedType;
import arcomat.symbols.names.EnumSymbol;
import arcomat.symbols.names.Names;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.TypeVariable;
import arcomat.symbols.signatures.Signature;
import arcomat.tree.ClassDiagram;
import arcomat.tree.Name;
import arcomat.tree.Unit;

import java.util.Optional;

/**
 * What a name stands for. Of one workspace, two are equal where they are declared by the same text,
 * through whichever part or heir they are seen.
 */
public sealed interface Referent {
    /** The forms: whoever has an answer for each is asked for all by the compiler. */
    enum Kind {
        PACKAGE,
        COMPONENT,
        DIAGRAM,
        TYPE,
        BUILTIN,
        TYPE_PARAMETER,
        CONSTANT,
        ATTRIBUTE,
        PORT,
        PART,
        VARIABLE,
        BOUND,
        PARAMETER,
        FEATURE,
        STATE,
        BEHAVIOUR,
        INVARIANT,
        SUITE,
        TEST
    }

    /**
     * What each has.
     *
     * @param name the simple one
     * @param place where the name is declared; where the type is, if the name is implicit. Empty
     *     for packages, which are there by being named, and for types that are built in.
     */
    record Declared(Kind kind, String name, Optional<Span> place) {
        private static Declared at(Span place, Kind kind, String name) {
            return new Declared(kind, name, Optional.of(place));
        }

        private static Declared nowhere(Kind kind, String name) {
            return new Declared(kind, name, Optional.empty());
        }
    }

    /** Takes the sum apart: one answer for each form. */
    <R> R match(ReferentCases<R> cases);

    Declared declared();

    default Kind kind() {
        return declared().kind();
    }

    default String name() {
        return declared().name();
    }

    default Optional<Span> declaration() {
        return declared().place();
    }

    /** Whether it has its name from its type, which alone is written. */
    default boolean isImplicit() {
        return false;
    }

    /** Itself; of an array, the element that is meant, or one of them where all are. */
    default Referent one() {
        return this;
    }

    /** What is named in front of the dot, where it is named by a path. */
    default Optional<Referent> around() {
        return Optional.empty();
    }

    /** What it is one of: a port's type, a part's component. */
    default Optional<Referent> typeReferent() {
        return Optional.empty();
    }

    /** What a type is in the text; empty where it is none of a model. */
    static Optional<Referent> ofType(TypeSymbol type) {
        return NamePlaces.referent(type);
    }

    /** Of a path through packages, the package; empty where there is none. */
    static Optional<Referent> qualifier(String qualifiedName) {
        return ofPackage(Names.qualifier(qualifiedName));
    }

    /** Empty for the default package. */
    static Optional<Referent> ofPackage(String qualifiedName) {
        return qualifiedName.isEmpty()
                ? Optional.empty()
                : Optional.of(new PackageName(qualifiedName));
    }

    static Referent diagramOf(Unit unit, ClassDiagram diagram) {
        return new Diagram(diagram.name(), Names.join(unit.packageText(), diagram.name().text()));
    }

    /** One of the names in a path of packages, with all in front of it. */
    record PackageName(String qualifiedName) implements Referent {
        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.packageName(this);
        }

        @Override
        public Declared declared() {
            return Declared.nowhere(
                    Kind.PACKAGE, qualifiedName.substring(qualifiedName.lastIndexOf('.') + 1));
        }

        @Override
        public Optional<Referent> around() {
            return Referent.qualifier(qualifiedName);
        }
    }

    record Component(Signature signature) implements Referent {
        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.component(this);
        }

        @Override
        public Declared declared() {
            return Declared.at(signature.nameSpan(), Kind.COMPONENT, signature.name());
        }

        @Override
        public Optional<Referent> around() {
            return signature
                    .enclosing()
                    .<Referent>map(Component::new)
                    .or(() -> Referent.qualifier(signature.qualifiedName()));
        }
    }

    record Diagram(Name written, String qualifiedName) implements Referent {
        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.diagram(this);
        }

        @Override
        public Declared declared() {
            return Declared.at(written.span(), Kind.DIAGRAM, written.text());
        }

        @Override
        public Optional<Referent> around() {
            return Referent.qualifier(qualifiedName);
        }
    }

    record Type(DefinedType symbol) implements Referent {
        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.type(this);
        }

        @Override
        public Declared declared() {
            return Declared.at(symbol.nameSpan(), Kind.TYPE, symbol.text());
        }

        @Override
        public Optional<Referent> around() {
            return Optional.of(
                    Referent.diagramOf(symbol.unit(), (ClassDiagram) symbol.unit().definition()));
        }
    }

    record Builtin(BuiltinType type) implements Referent {
        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.builtin(this);
        }

        @Override
        public Declared declared() {
            return Declared.nowhere(Kind.BUILTIN, type.text());
        }

        @Override
        public Optional<Referent> around() {
            return Optional.of(new PackageName("java.lang"));
        }
    }

    record TypeParameter(TypeVariable variable) implements Referent {
        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.typeParameter(this);
        }

        @Override
        public Declared declared() {
            return Declared.at(variable.node().name().span(), Kind.TYPE_PARAMETER, variable.text());
        }
    }

    record Constant(EnumSymbol type, int ordinal) implements Referent {
        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.constant(this);
        }

        private Name written() {
            return type.node().constants().get(ordinal);
        }

        @Override
        public Declared declared() {
            return Declared.at(written().span(), Kind.CONSTANT, written().text());
        }

        @Override
        public Optional<Referent> around() {
            return Optional.of(new Type(type));
        }

        @Override
        public Optional<Referent> typeReferent() {
            return Optional.of(new Type(type));
        }
    }

    record Attribute(AttributeSymbol symbol) implements Referent {
        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.attribute(this);
        }

        @Override
        public Declared declared() {
            return Declared.at(symbol.node().name().span(), Kind.ATTRIBUTE, symbol.name());
        }

        @Override
        public Optional<Referent> typeReferent() {
            return ofType(symbol.type());
        }
    }

    /**
     * @param symbol under the name that the component itself has for it
     */
    record Port(PortSymbol symbol) implements Referent {
        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.port(this);
        }

        @Override
        public Declared declared() {
            return Declared.at(symbol.nameSpan(), Kind.PORT, symbol.name());
        }

        @Override
        public Optional<Referent> typeReferent() {
            return ofType(symbol.type());
        }

        @Override
        public boolean isImplicit() {
            return symbol.implicit();
        }
    }

    record Part(InstanceSymbol symbol) implements Referent {
        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.part(this);
        }

        @Override
        public Declared declared() {
            return Declared.at(symbol.nameSpan(), Kind.PART, symbol.name());
        }

        @Override
        public Optional<Referent> typeReferent() {
            return symbol.type().component().map(Component::new);
        }

        @Override
        public boolean isImplicit() {
            return symbol.origin() != InstanceSymbol.Origin.NAMED;
        }
    }

    /** Of an automaton, or a constant of a component. */
    record Variable(VariableSymbol symbol) implements Referent {
        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.variable(this);
        }

        @Override
        public Declared declared() {
            return Declared.at(symbol.nameSpan(), Kind.VARIABLE, symbol.name());
        }

        @Override
        public Optional<Referent> typeReferent() {
            return ofType(symbol.type());
        }
    }

    /**
     * An array of ports, parts or variables, as it is named where one of its elements is, or all
     * are. What it is called they are called together.
     *
     * @param one an element
     * @param isWhole whether others are meant as well
     */
    record Array(Referent one, boolean isWhole) implements Referent {

        /** Of what is no element, itself. */
        public static Referent around(Referent one) {
            return ArrayNames.isElement(one.name()) ? new Array(one, false) : one;
        }

        /** Of what is no element, itself; of an element, all that are declared with it. */
        public static Referent whole(Referent one) {
            return ArrayNames.isElement(one.name()) ? new Array(one, true) : one;
        }

        Array and(Referent other) {
            return isWhole || one.equals(other.one()) ? this : new Array(one, true);
        }

        private Span written() {
            return one.declaration().orElseThrow();
        }

        /** How many elements it has, as it is written. */
        public String size() {
            return ArrayNames.writtenSize(written());
        }

        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.array(this);
        }

        @Override
        public Declared declared() {
            String name = ArrayNames.array(one.name());
            return Declared.at(ArrayNames.word(written(), name), one.kind(), name);
        }

        @Override
        public Optional<Referent> typeReferent() {
            return one.typeReferent();
        }

        /** By where it is declared, whichever element is looked at. */
        @Override
        public boolean equals(Object other) {
            return other instanceof Array array
                    && array.kind() == kind()
                    && array.declaration().equals(declaration());
        }

        @Override
        public int hashCode() {
            return declaration().hashCode();
        }
    }

    /** What a quantifier or {@code let} has given a name to. */
    record Bound(Unfolded.Bound bound) implements Referent {
        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.bound(this);
        }

        @Override
        public Declared declared() {
            return Declared.at(bound.name().span(), Kind.BOUND, bound.name().text());
        }

        /** A deep tree has no place in a hash. */
        @Override
        public boolean equals(Object other) {
            return other instanceof Bound read && read.bound.name().equals(bound.name());
        }

        @Override
        public int hashCode() {
            return bound.name().hashCode();
        }
    }

    record Parameter(ParameterSymbol symbol) implements Referent {
        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.parameter(this);
        }

        @Override
        public Declared declared() {
            return Declared.at(symbol.nameSpan(), Kind.PARAMETER, symbol.name());
        }

        @Override
        public Optional<Referent> typeReferent() {
            return ofType(symbol.type());
        }
    }

    /**
     * What may be chosen of a component.
     *
     * @param component the name of that
     */
    record Feature(Name written, String component) implements Referent {
        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.feature(this);
        }

        @Override
        public Declared declared() {
            return Declared.at(written.span(), Kind.FEATURE, written.text());
        }
    }

    record State(AutomatonSymbol automaton, StateSymbol symbol) implements Referent {
        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.state(this);
        }

        @Override
        public Declared declared() {
            return Declared.at(symbol.nameSpan(), Kind.STATE, symbol.name());
        }
    }

    /** An automaton or an {@code implementation} with a name, to which nothing can refer. */
    record Behaviour(Name written) implements Referent {
        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.behaviour(this);
        }

        @Override
        public Declared declared() {
            return Declared.at(written.span(), Kind.BEHAVIOUR, written.text());
        }
    }

    record Invariant(InvariantSymbol symbol) implements Referent {
        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.invariant(this);
        }

        @Override
        public Declared declared() {
            return Declared.at(symbol.nameSpan(), Kind.INVARIANT, symbol.name());
        }
    }

    record Suite(TestSuiteSymbol symbol) implements Referent {
        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.suite(this);
        }

        @Override
        public Declared declared() {
            return Declared.at(symbol.node().name().span(), Kind.SUITE, symbol.name());
        }
    }

    record Test(StreamTestSymbol symbol) implements Referent {
        @Override
        public <R> R match(ReferentCases<R> cases) {
            return cases.test(this);
        }

        @Override
        public Declared declared() {
            return Declared.at(symbol.node().name().span(), Kind.TEST, symbol.name());
        }
    }
}
