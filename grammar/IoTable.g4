/*
 * I/O tables: a second behaviour language. A row lists the cells of the inputs, then those of the
 * outputs; the first row that matches decides.
 */
grammar IoTable;

import Automaton;

ioTable
    : stereotypes? keyword = 'table' open = '{' tableInputs? tableOutputs? row* '}'
    ;

tableInputs
    : 'in' place (',' place)* ';'
    ;

tableOutputs
    : 'out' place (',' place)* ';'
    ;

row
    : '|' (inputs += cell '|')* '=>' ('|' outputs += cell)* '|' ';'
    ;

cell
    : '*'                                                                   # anyCell
    | value                                                                 # valueCell
    ;
