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
    | 'initial' name (',' name)* ('/' effect)? ';'                          # initial
    | 'initial' effect name (',' name)* ';'                                 # initialBehind
    | 'initial' effect? 'state' state (',' state)* ';'                      # initialStates
    | source = name ('->' target = name)? guard? input = block? ('/' effect)? ';'   # transition
    | plainType valuedVariable (',' variable)* ';'                          # plainDeclaration
    ;

// As a component declares them. With a value: "sate open;" is a misspelt word, and no variable.
valuedVariable
    : declared '=' expression
    ;

state
    : stereotypes? name
    ;

guard
    : '[' (name ':')? expression ']'
    ;

// What a block says happens at once, statements one after the other.
effect
    : block
    | 'do' statements
    ;

statements
    : '{' statement* '}'
    ;

statement
    : statements                                                            # nestedStatements
    | 'if' '(' expression ')' then = statement ('else' otherwise = statement)?   # choiceStatement
    | 'var' type variable (',' variable)* ';'                               # markedLocals
    | plainType variable (',' variable)* ';'                                # plainLocals
    | place '=' value ';'                                                   # assignment
    | place operator = ('+=' | '-=') expression ';'                         # changeStatement
    | place operator = ('++' | '--') ';'                                    # stepStatement
    ;

block
    : '{' (item ((',' | ';') item)* (',' | ';')?)? '}'
    ;

item
    : place ('==' | '=') value ('|' value)*
    | 'call' expression
    | qualifiedPlace operator = ('++' | '--')
    | value ('|' value)*
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
