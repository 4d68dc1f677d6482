/*
 * I/O-omega automata, embedded in a component or alone in a file (*.ioautomaton).
 */
grammar Automaton;

import Expression;

automatonUnit
    : header automaton EOF
    ;

automaton
    : stereotypes? 'automaton' name? '{' automatonElement* '}'
    ;

automatonElement
    : kind = ('variable' | 'input' | 'output') type variable (',' variable)* ';'    # declaration
    | 'var' type variable (',' variable)* ';'                               # markedDeclaration
    | 'state' state (',' state)* ';'                                        # states
    | 'initial' name (',' name)* ('/' block)? ';'                           # initial
    | source = name ('->' target = name)? guard? input = block? ('/' output = block)? ';'   # transition
    | plainType valuedVariable (',' variable)* ';'                          # plainDeclaration
    ;

// As a component declares them. With a value: "sate open;" is a misspelt word, and no variable.
valuedVariable
    : name '=' expression
    ;

state
    : stereotypes? name
    ;

guard
    : '[' (name ':')? expression ']'
    ;

block
    : '{' (item ((',' | ';') item)* (',' | ';')?)? '}'
    ;

item
    : name ('==' | '=') value
    | 'call' expression
    | qualifiedName operator = ('++' | '--')
    | value
    ;

value
    : alternatives
    | sequence
    | nothing = '--'
    | anything = '?'
    | expression
    ;

alternatives
    : 'alt' '{' value (',' value)* '}'
    ;

sequence
    : '[' expression (',' expression)* ']'
    ;
