/*
 * UML/P class diagrams: the types of messages, and what the older tools wrote beside them.
 */
grammar ClassDiagram;

import Expression;

classDiagramUnit
    : header classDiagram EOF
    ;

classDiagram
    : stereotypes? 'classdiagram' name '{' typeDefinition* '}'
    ;

typeDefinition
    : stereotypes? typeModifier* 'enum' name implemented?
      '{' (enumConstant (',' enumConstant)*)? ','? (';' typeMember*)? '}' ';'?                 # enumDefinition
    | stereotypes? typeModifier* 'class' name ('extends' type)? implemented? typeBody         # classDefinition
    | stereotypes? typeModifier* 'interface' name ('extends' type (',' type)*)? typeBody      # interfaceDefinition
    | stereotypes? 'type' name ';'                                                            # opaqueDefinition
    | stereotypes? typeModifier* kind = ('association' | 'aggregation' | 'composition') name?
      leftEnd associationArrow rightEnd ';'                                                   # associationDefinition
    ;

typeModifier
    : 'public' | 'protected' | 'private' | 'abstract' | 'final' | 'static' | 'derived'
    | '+' | '#' | '-' | '/'
    ;

implemented
    : 'implements' type (',' type)*
    ;

enumConstant
    : name arguments?
    ;

typeBody
    : '{' typeMember* '}' ';'?
    | ';'
    ;

typeMember
    : stereotypes? typeModifier* type name ('=' expression)? ';'            # attributeMember
    | stereotypes? typeModifier* result = type? name methodParameters
      ('throws' thrown += type (',' thrown += type)*)? (javaBlock | ';')                        # methodMember
    ;

methodParameters
    : '(' (methodParameter (',' methodParameter)*)? ')'
    ;

methodParameter
    : type name
    ;

// Two characters each: with "<-" and "<->" in one, "a <-b" would be no comparison.
associationArrow
    : '->'
    | '<' '->'
    | '<' '-'
    | '--'
    ;

leftEnd
    : property? cardinality? qualifiedName qualifier? role?
    ;

rightEnd
    : role? qualifier? qualifiedName cardinality? property?
    ;

// What UML says of an end: ordered, unique.
property
    : '{' name (',' name)* '}'
    ;

cardinality
    : '[' ('*' | INT ('..' (INT | '*'))?) ']'
    ;

qualifier
    : '[' '[' name ']' ']'
    | '[' type ']'
    ;

role
    : '(' name ')'
    ;
