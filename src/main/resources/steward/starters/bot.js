// A starter bot for {{game}}: copy it and make it better. It needs nothing but Node.js.
//
{{#codingame}}
// It speaks CodinGame's lines: words and numbers. The referee sends some before the first turn and some every turn, and
// every turn it waits for an answer. Use stderr for your own notes: console.error('hello')
{{/codingame}}
{{#json}}
// The referee sends one JSON object a line: a "setup", a "turn" for every turn, and an "end". Every "turn" is answered
// by one line. Use stderr for your own notes: console.error('hello')
{{/json}}
'use strict';
const fs = require('fs');

function main() {
{{#json}}
  let frame = readFrame();                  // before the first turn
{{/json}}
{{#codingame}}
  // Before the first turn.
{{/codingame}}
{{#readings}}
{{#every}}
  for (;;) {
{{#json}}
    frame = readFrame();                    // every turn
{{/json}}
{{#codingame}}
    // Every turn. All of it has to be read, whether you use it or not.
{{/codingame}}
{{/every}}
{{#inputs}}
{{#variables}}
  {{step}}const {{name}} = {{kind}}({{#json}}frame, '{{key}}'{{/json}});
{{/variables}}
{{#record}}
  {{step}}const {{name}} = read{{type}}({{#json}}frame.{{key}} || {}{{/json}});
{{/record}}
{{#list}}
  {{step}}const {{name}} = {{#json}}(frame.{{key}} || []).map(read{{type}}){{/json}}{{#codingame}}Array.from({ length: {{count}} }, read{{type}}){{/codingame}};
{{/list}}
{{/inputs}}
{{/readings}}

    // Change this: it decides what you answer.
{{#notes}}
    // {{note}}
{{/notes}}
{{#json}}
    const answers = [];
{{/json}}
{{#commands}}
{{#list}}
    for (const {{#indexed}}[index, {{name}}] of {{list}}.entries(){{/indexed}}{{^indexed}}{{name}} of {{list}}{{/indexed}}) {
{{/list}}
{{^list}}
    {
{{/list}}
{{#where}}
      if (!({{where}})) {
        continue;
      }
{{/where}}
{{#locals}}
      const {{name}} = {{value}};
{{/locals}}
{{#nearest}}
      // The nearest {{name}}, or undefined.
      const {{name}} = nearest({{from}}, {{list}}{{#where}}.filter(each => {{where}}){{/where}});
{{/nearest}}
{{#choices}}
{{#if}}
      if ({{when}}) {
{{/if}}
{{#elseif}}
      } else if ({{when}}) {
{{/elseif}}
{{#else}}
      } else {
{{/else}}
      {{#nested}}  {{/nested}}{{#codingame}}console.log({{#parts}}{{#wrap}}
        {{/wrap}}{{value}}{{^last}}, {{/last}}{{/parts}}){{/codingame}}{{#json}}answers.push({ {{#parts}}{{#wrap}}
        {{/wrap}}{{key}}: {{value}}{{^last}}, {{/last}}{{/parts}} }){{/json}};
{{#end}}
      }
{{/end}}
{{/choices}}
    }
{{/commands}}
{{#json}}
    console.log(JSON.stringify({{#answer}}{ {{answer}}: answers }{{/answer}}{{^answer}}answers[0]{{/answer}}));
{{/json}}
  }
}
{{#nearest}}

function nearest(place, candidates) {
  let best;
  for (const each of candidates) {
    if (!best || distance(place.x, place.y, each.x, each.y) < distance(place.x, place.y, best.x, best.y)) {
      best = each;
    }
  }
  return best;
}
{{/nearest}}
{{#distance}}

function distance(x, y, otherX, otherY) {
  return Math.hypot(otherX - x, otherY - y);
}
{{/distance}}
{{#degrees}}

// How many degrees, 0..180, a heading is off the direction from a place to another.
function degreesOff(x, y, heading, otherX, otherY) {
  const wanted = Math.atan2(otherY - y, otherX - x) * 180 / Math.PI;
  return Math.abs(((wanted - heading + 540) % 360 + 360) % 360 - 180);
}
{{/degrees}}

// Reading. There is nothing to change from here on.
{{#records}}
function read{{type}}({{#json}}each{{/json}}) {
  return {
{{#fields}}
    {{name}}: {{kind}}({{#json}}each, '{{key}}'{{/json}}),
{{/fields}}
  };
}

{{/records}}
const buffer = Buffer.alloc(65536);
let rest = Buffer.alloc(0);

// The next line; the program ends when the referee closes our input.
function readLine() {
  while (rest.indexOf('\n') < 0) {
    const count = fs.readSync(0, buffer, 0, buffer.length, null);
    if (count === 0) {
      process.exit(0);
    }
    rest = Buffer.concat([rest, buffer.subarray(0, count)]);
  }
  const end = rest.indexOf('\n');
  const line = rest.toString('utf8', 0, end);
  rest = rest.subarray(end + 1);
  return line;
}
{{#codingame}}

let words = [];

function word() {
  while (words.length === 0) {
    words = readLine().split(/\s+/).filter(each => each !== '');
  }
  return words.shift();
}

function integer() {
  return parseInt(word(), 10);
}

function number() {
  return parseFloat(word());
}
{{/codingame}}
{{#json}}

// The next frame; the program ends with the last one.
function readFrame() {
  const frame = JSON.parse(readLine());
  if (frame.type === 'end') {
    process.exit(0);
  }
  return frame;
}

// A number of an object, -1 if there is none.
function number(values, key) {
  return typeof values[key] === 'number' ? values[key] : -1;
}

function integer(values, key) {
  return Math.trunc(number(values, key));
}

function word(values, key) {
  return String(values[key] === undefined ? '' : values[key]);
}
{{/json}}

main();
