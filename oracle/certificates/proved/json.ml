(* SPDX-License-Identifier: Apache-2.0 *)
(* Reads one line of JSON. One text has one meaning: a key given twice is refused, and so is half of a surrogate pair,
   and what is nested more than 64 deep. Numbers stay text. *)

type t = Null | Bool of bool | Number of string | Text of string | List of t list | Object of (string * t) list

exception Malformed

let most_nested = 64

let utf8 buffer code =
  if Uchar.is_valid code then Buffer.add_utf_8_uchar buffer (Uchar.of_int code) else raise Malformed

(* No surrogates, nothing longer than it has to be. *)
let is_utf8 text =
  let length = String.length text in
  let byte at = Char.code text.[at] in
  let rec follow at count code = if count = 0 then Some code
    else if at < length && byte at land 0xC0 = 0x80 then follow (at + 1) (count - 1)
      ((code lsl 6) lor (byte at land 0x3F))
    else None in
  let rec from at =
    if at >= length then true
    else
      let first = byte at in
      let count, least, code =
        if first < 0x80 then (0, 0, first)
        else if first land 0xE0 = 0xC0 then (1, 0x80, first land 0x1F)
        else if first land 0xF0 = 0xE0 then (2, 0x800, first land 0x0F)
        else (3, 0x10000, if first land 0xF8 = 0xF0 then first land 0x07 else -1) in
      match follow (at + 1) count code with
      | Some code when code >= least && Uchar.is_valid code -> from (at + 1 + count)
      | _ -> false in
  from 0

(* A character that stands for itself in a text *)
let plain c = c >= ' ' && c <= '~' && c <> '"' && c <> '\\'

let parse text =
  let length = String.length text and at = ref 0 and beyond_ascii = ref false in
  let peek () = if !at < length then text.[!at] else '\000' in
  let take c = if peek () = c && !at < length then incr at else raise Malformed in
  let rec skip_spaces () = match peek () with ' ' | '\t' | '\r' | '\n' -> incr at; skip_spaces () | _ -> () in
  let literal name value = String.iter take name; value in
  let four_digits () =
    if !at + 4 > length then raise Malformed;
    let digits = String.sub text !at 4 in
    String.iter (function '0' .. '9' | 'a' .. 'f' | 'A' .. 'F' -> () | _ -> raise Malformed) digits;
    at := !at + 4;
    int_of_string ("0x" ^ digits) in
  let escaped buffer =
    let c = peek () in
    incr at;
    match c with
    | '"' | '\\' | '/' -> Buffer.add_char buffer c
    | 'b' -> Buffer.add_char buffer '\b'
    | 'f' -> Buffer.add_char buffer '\012'
    | 'n' -> Buffer.add_char buffer '\n'
    | 'r' -> Buffer.add_char buffer '\r'
    | 't' -> Buffer.add_char buffer '\t'
    | 'u' ->
        let first = four_digits () in
        if first land 0xFC00 = 0xD800 then begin
          take '\\'; take 'u';
          let second = four_digits () in
          if second land 0xFC00 <> 0xDC00 then raise Malformed;
          utf8 buffer (0x10000 + ((first land 0x3FF) lsl 10) + (second land 0x3FF))
        end
        else utf8 buffer first
    | _ -> raise Malformed in
  let rec text_value () =
    take '"';
    let first = !at in
    while !at < length && plain text.[!at] do incr at done;
    let begun = String.sub text first (!at - first) in
    if peek () = '"' then (incr at; begun) else rest_of_text begun
  and rest_of_text begun =
    let buffer = Buffer.create 16 in
    Buffer.add_string buffer begun;
    let rec go () =
      if !at >= length then raise Malformed;
      let c = text.[!at] in
      incr at;
      match c with
      | '"' -> ()
      | '\\' -> escaped buffer; go ()
      | c when c < ' ' -> raise Malformed
      | c ->
          if c > '~' then beyond_ascii := true;
          Buffer.add_char buffer c;
          go () in
    go ();
    Buffer.contents buffer in
  let digits () =
    let first = !at in
    while peek () >= '0' && peek () <= '9' do incr at done;
    if !at = first then raise Malformed in
  let number () =
    let first = !at in
    if peek () = '-' then incr at;
    if peek () = '0' then incr at else digits ();
    if peek () = '.' then (incr at; digits ());
    if peek () = 'e' || peek () = 'E' then begin
      incr at;
      if peek () = '+' || peek () = '-' then incr at;
      digits ()
    end;
    let written = String.sub text first (!at - first) in
    if Float.is_finite (float_of_string written) then written else raise Malformed in
  let rec value depth =
    if depth > most_nested then raise Malformed;
    skip_spaces ();
    let found = match peek () with
      | '{' -> incr at; Object (once (items '}' (fun () -> skip_spaces (); member depth)))
      | '[' -> incr at; List (items ']' (fun () -> value (depth + 1)))
      | '"' -> Text (text_value ())
      | 't' -> literal "true" (Bool true)
      | 'f' -> literal "false" (Bool false)
      | 'n' -> literal "null" Null
      | _ -> Number (number ()) in
    skip_spaces ();
    found
  and member depth =
    let key = text_value () in
    skip_spaces ();
    take ':';
    (key, value (depth + 1))
  and items : 'a. char -> (unit -> 'a) -> 'a list = fun close item ->
    skip_spaces ();
    if peek () = close then (incr at; [])
    else
      let rec go found =
        let found = item () :: found in
        skip_spaces ();
        if peek () = ',' then (incr at; go found) else (take close; List.rev found) in
      go []
  and once members =
    let keys = List.map fst members in
    if List.length (List.sort_uniq String.compare keys) <> List.length keys then raise Malformed;
    members in
  let found = value 0 in
  if !at < length || (!beyond_ascii && not (is_utf8 text)) then raise Malformed;
  found
