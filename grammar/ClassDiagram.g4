/*
 * UML/P class diagrams, as far as they define message types.
 */
grammar ClassDiagram;

import Expression;

classDiagramUnit
    : header classDiagram EOF
    ;

classDiagram
    : 'classdiagram' name '{' typeDefinition* '}'
    ;

typeDefinition
    : 'enum' name '{' (constants += name (',' constants += name)*)? ','? ';'? '}' ';'?      # enumDefinition
    | 'class' name ('extends' type)? ('{' attribute* '}' | ';')             # classDefinition
    ;

attribute
    : type name ';'
    ;
